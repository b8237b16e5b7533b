// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One step of one point, or of a vector of points. There is no include guard: the file is compiled for each kind of
// machine, inside its namespace, and BETWIXT_INLINE says how to inline.

template <class V>
BETWIXT_INLINE void shear(V& x, V& y, V a, V b) {
  x = x + a * y;
  y = y + b * x;
  x = x + a * y;
}

template <class V>
BETWIXT_INLINE void draw(Lane<V>& p, V x, V y) {
  p.ox = p.x + x, p.oy = p.y + y;
}

// k: the inputs of the kernel, in the order of their use here.
template <Kernel kernel, class V>
BETWIXT_INLINE void step(Lane<V>& p, const V* k) {
  if constexpr (kernel == Kernel::offset) {
    draw(p, k[0], k[1]);
  } else if constexpr (kernel == Kernel::scale) {
    p.ox = k[0] * p.x + k[2], p.oy = k[1] * p.y + k[3];
  } else if constexpr (kernel == Kernel::matrix) {  // a, -b, c, d
    p.ox = k[0] * p.x - k[1] * p.y + k[4], p.oy = k[2] * p.x + k[3] * p.y + k[5];
  } else if constexpr (kernel == Kernel::move) {
    p.x = p.x + k[0], p.y = p.y + k[1];
  } else if constexpr (kernel == Kernel::slide) {
    p.x = p.x + p.u, p.y = p.y + p.v;
  } else if constexpr (kernel == Kernel::stretch) {
    p.x = k[0] * p.x + k[2], p.y = k[1] * p.y + k[3];
  } else if constexpr (kernel == Kernel::turn) {  // cos, sin
    const V x = k[0] * p.x - k[1] * p.y + k[2], y = k[1] * p.x + k[0] * p.y + k[3];
    p.x = x, p.y = y;
  } else if constexpr (kernel == Kernel::grow) {
    p.x = k[0] * p.x, p.y = k[1] * p.y;
    draw(p, k[2], k[3]);
  } else if constexpr (kernel == Kernel::ramp) {
    p.x = p.x + p.u, p.y = p.y + p.v;
    draw(p, k[0], k[1]);
  } else if constexpr (kernel == Kernel::two_term) {
    const V x = k[0] * p.x - p.u, y = k[0] * p.y - p.v;
    p.u = p.x, p.v = p.y, p.x = x, p.y = y;
    draw(p, k[1], k[2]);
  } else if constexpr (kernel == Kernel::damped) {
    const V x = k[0] * p.x - k[2] * p.u, y = k[1] * p.y - k[3] * p.v;
    p.u = p.x, p.v = p.y, p.x = x, p.y = y;
    draw(p, k[4], k[5]);
  } else if constexpr (kernel == Kernel::conformal) {  // re, re + im, im - re
    const V both = k[0] * (p.x + p.y), x = both - k[1] * p.y;
    p.y = both + k[2] * p.x;
    p.x = x;
    draw(p, k[3], k[4]);
  } else if constexpr (kernel == Kernel::shears) {
    shear(p.x, p.y, k[0], k[1]);
    draw(p, k[2], k[3]);
  } else if constexpr (kernel == Kernel::pushed_shears) {
    shear(p.x, p.y, k[0], k[1]);
    p.x = p.x + k[4], p.y = p.y + k[5];
    draw(p, k[2], k[3]);
  } else if constexpr (kernel == Kernel::carried_shears) {
    p.x = p.x + p.u, p.y = p.y + p.v;
    shear(p.x, p.y, k[0], k[1]);
    draw(p, k[2], k[3]);
    shear(p.u, p.v, k[0], k[1]);
  } else {
    shear(p.x, p.y, k[0], k[1]);
    p.u = p.u + p.du, p.v = p.v + p.dv;
    draw(p, p.u, p.v);
  }
}

// Steps the points one after the other.
template <Kernel k, class Number>
BETWIXT_INLINE void step_each(const Arrays<Number>& a, const Number* inputs) {
  constexpr Uses use = uses(k);
  for (std::size_t i = 0; i < a.count; ++i) {
    Lane<Number> p{a.x[i], a.y[i]};
    if constexpr (use.second) p.u = a.u[i], p.v = a.v[i];
    if constexpr (use.gain) p.du = a.du[i], p.dv = a.dv[i];
    step<k>(p, inputs);
    if constexpr (use.state) a.x[i] = p.x, a.y[i] = p.y;
    if constexpr (use.written) a.u[i] = p.u, a.v[i] = p.v;
    if constexpr (use.drawn) a.ox[i] = p.ox, a.oy[i] = p.oy;
  }
}
