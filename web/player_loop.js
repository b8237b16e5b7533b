// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One loop for all players of a page, which runs while a visible picture may change. It also tells each player whether it
// is visible or near the visible part of the page, its size, and when the screen or the zoom changes.
const player_loop = () => {
  const callbacks = new WeakMap();  // by player: step, see, comes_near, measure
  const watched = new Set(), awake = new Set();
  let due = 0;
  const beat = () => {
    due = 0;
    const now = [...awake];
    awake.clear();
    for (const player of now)
      if (player.isConnected && callbacks.get(player).step()) wake(player);
  };
  const wake = (player) => {
    awake.add(player);
    due ||= requestAnimationFrame(beat);
  };

  const seen = new IntersectionObserver((all) => {
    for (const one of all) callbacks.get(one.target).see(one.isIntersecting);
  });
  const near = new IntersectionObserver((all) => {
    for (const one of all)
      if (one.isIntersecting) callbacks.get(one.target).comes_near();
  }, { rootMargin: "100% 25%" });
  const sizes = new ResizeObserver((all) => {
    for (const one of all) callbacks.get(one.target.getRootNode().host).measure(one.contentRect);
  });
  // Redraws on another screen or another zoom: the size on the page stays, but the number of screen pixels changes.
  const watch_pixels = () => {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      for (const player of watched) wake(player);
      watch_pixels();
    }, { once: true });
  };
  watch_pixels();

  return {
    wake,
    add(player, its_callbacks) { callbacks.set(player, its_callbacks); },
    watch(player, stage) {
      seen.observe(player);
      near.observe(player);
      sizes.observe(stage);
      watched.add(player);
    },
    leave(player, stage) {
      seen.unobserve(player);
      near.unobserve(player);
      sizes.unobserve(stage);
      watched.delete(player);
      awake.delete(player);
    },
    // Asks again whether the player is near; is_near: no longer asks.
    ask(player) { near.unobserve(player), near.observe(player); },
    is_near(player) { near.unobserve(player); },
  };
};
