// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What scenes and geometries of Embree are made of.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <vector>

namespace betwixt::traced {

inline void set_flags(RTCScene scene) {
  rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
}

// `step`: which state of something that moves.
template <class T>
T* new_buffer(RTCGeometry g, RTCBufferType type, unsigned step, RTCFormat format, std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(g, type, step, format, sizeof(T), count));
}

inline bool indices_fit(const std::vector<std::uint32_t>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [count](std::uint32_t i) { return i < count; });
}

}  // namespace betwixt::traced
