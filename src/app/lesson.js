// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
'use strict';
(() => {
  const lesson = JSON.parse(document.getElementById('lesson').textContent);
  const {factors, unit, figure, points} = lesson;
  const count = factors.length;
  const byId = (id) => document.getElementById(id);
  const svgSpace = byId('play').querySelector('svg').namespaceURI;

  // ---- The algebra. A matrix [a b c d e f] takes (x, y) to (a x + c y + e, b x + d y + f).

  const identity = [1, 0, 0, 1, 0, 0];
  const times = (m, n) =>
      [m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
       m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5]];
  const moved = (m, [x, y]) => [m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]];
  const about = ([x, y], [a, b, c, d]) => [a, b, c, d, x - a * x - c * y, y - b * x - d * y];

  // Of fraction t. Whole turns are taken off first: the sine of a large angle is less exact.
  const factorAt = (f, t, linear) => {
    if (f.kind === 'T') return [1, 0, 0, 1, t * f.by[0], t * f.by[1]];
    if (f.kind === 'R') {
      const part = t * f.turns, angle = 2 * Math.PI * (part - Math.round(part));
      const s = Math.sin(angle), c = Math.cos(angle);
      return about(f.centre, [c, s, -s, c]);
    }
    const grown = (g) => f.linear || linear ? 1 + (g - 1) * t : Math.pow(g, t);
    return about(f.centre, [grown(f.by[0]), 0, 0, grown(f.by[1])]);
  };
  const product = (some, t, linear) => some.reduce((m, f) => times(m, factorAt(f, t, linear)), identity);
  const motion = (t) => product(factors, t);

  // ---- Words

  const number = (x, digits = 4) => {
    if (x === null || !Number.isFinite(x)) return '∞';
    const short = +x.toPrecision(digits);
    return (Math.abs(short) >= 1e6 || (short !== 0 && Math.abs(short) < 1e-4) ? short.toExponential() : String(short))
        .replace(/-/g, '−')
        .replace('e+', 'e');
  };
  const place = ([x, y], digits) => `(${number(x, digits)}, ${number(y, digits)})`;
  // As many digits at any time, so that they do not jump about; small figures have small numbers.
  const fixed = (x) => {
    if (Math.abs(x) < 1e-7 * Math.min(1, unit)) x = 0;
    if (Math.abs(x) >= 1e7 || (unit < 0.01 && x !== 0 && Math.abs(x) < 0.01)) return number(x, 5);
    return x.toFixed(Math.abs(x) >= 1000 ? 1 : Math.abs(x) >= 100 ? 3 : 5).replace('-', '−');
  };
  // An error of floating point, as one says it.
  const tiny = (x) => {
    if (x === null) return 'lost';
    if (x === 0) return 'none';
    return x >= 0.01 ? number(x, 2) : x.toExponential(1).replace('-', '−');
  };
  const grouped = (n) => n.toLocaleString('en').replace(/,/g, '\u202f');
  const counted = (n, one, many) => `${n} ${n === 1 ? one : many}`;

  const way = ([x, y]) => {
    const parts = [];
    if (x !== 0) parts.push(`${number(Math.abs(x))} to the ${x > 0 ? 'right' : 'left'}`);
    if (y !== 0) parts.push(`${number(Math.abs(y))} ${y > 0 ? 'up' : 'down'}`);
    return parts.join(' and ');
  };
  const turning = (turns) => {
    const size = Math.abs(turns), whole = Math.abs(size - Math.round(size)) < 1e-9;
    if (size === 0.5) return 'half a turn';
    if (size === 0.25) return 'a quarter of a turn';
    if (whole && size > 0.5) return Math.round(size) === 1 ? 'one whole turn' : `${number(size, 12)} whole turns`;
    return size < 1 ? `by ${number(360 * size)}°` : `${number(size, 8)} turns`;
  };
  const growth = (g) => {
    const plain = {'-1': 'its own mirror image', '0': 'zero', '0.5': 'half as large', '2': 'twice as large'};
    const size = Math.abs(g), digits = Math.abs(size - 1) < 1e-3 ? 17 : 4;  // or nearly 1 would be 1
    return plain[g] || `${g < 0 ? 'mirrored and ' : ''}${number(size, digits)} times as large`;
  };
  const centreOf = (f) => f.about ? `${f.about}, here at ${place(f.centre)}` : place(f.centre);
  const described = (f) => {
    if (f.kind === 'T') return f.by[0] || f.by[1] ? `Moves everything ${way(f.by)}.` : 'Moves nothing.';
    if (f.kind === 'R') {
      if (f.turns === 0) return 'Turns nothing.';
      const round = f.turns > 0 ? 'counterclockwise' : 'clockwise';
      return `Turns everything ${turning(f.turns)} about ${centreOf(f)}, ${round}.`;
    }
    const [x, y] = f.by;
    let what = `Makes the width ${growth(x)} and the height ${growth(y)}`;
    if (x === 1 && y === 1) return 'Leaves every size as it is.';
    if (x === y) what = x === 0 ? 'Shrinks everything to one point' : `Makes everything ${growth(x)}`;
    else if (y === 1) what = `Makes the width ${growth(x)}`;
    else if (x === 1) what = `Makes the height ${growth(y)}`;
    const all = (fits) => f.by.every(fits);
    const does = all((g) => g >= 1) ? 'grows' : all((g) => g >= 0 && g <= 1) ? 'shrinks' : 'changes';
    return `${what}. The centre ${centreOf(f)} stays. The size ${does} by the same `
        + (f.linear ? 'amount in every step (the linear law).' : 'factor in every step (the exponential law).');
  };
  // What of the factor is done by t.
  const partly = (f, t) => {
    let at = '';
    if (f.about) at = ` @ ${f.about}`;
    else if (f.centre && (f.centre[0] || f.centre[1])) at = ` @ ${f.centre.map((x) => number(x)).join(' ')}`;
    if (f.kind === 'T') return `T(${f.by.map((x) => number(t * x)).join(' ')})`;
    if (f.kind === 'R') return `R(${number(360 * t * f.turns)}°${at})`;
    const m = factorAt(f, t);
    return `S(${number(m[0])} ${number(m[3])}${at})`;
  };

  // ---- Elements. Text is only ever set as text.

  const put = (parent, name, attributes = {}, text) => {
    const space = parent.namespaceURI === svgSpace || name === 'svg' ? svgSpace : parent.namespaceURI;
    const element = parent.appendChild(document.createElementNS(space, name));
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    if (text !== undefined) element.textContent = text;
    return element;
  };
  const colour = (i) => `var(--f${i % 6})`;

  // ---- Pictures

  const pictures = [];  // what is drawn anew when t changes
  const corners = figure.concat(points);
  const tip = figure[8], foot = figure[0];
  const followed =
      [{p: tip, name: 'the top'}, {p: foot, name: 'the foot'}].concat(points.map((p) => ({p, name: place(p)})));
  const followedColour = (i) => i === 0 ? 'var(--accent)' : i === 1 ? 'var(--other)' : colour(i);

  const turnsOf = (some) => some.reduce((n, f) => n + (f.kind === 'R' ? Math.abs(f.turns) : 0), 0);
  const exponentsOf = (some) => some.reduce(
      (n, f) => n + (f.kind === 'S' && !f.linear ? Math.max(...f.by.map((g) => Math.abs(Math.log(g)))) : 0), 0);
  const evenly = (from, to, n) => Array.from({length: n + 1}, (_, k) => from + (to - from) * k / n);

  // The moments that a path is drawn through, so many that a quick turn looks round. More turns than can be told apart
  // are not drawn one by one: `line` is the first of them then, and `shade` shows where they run. It has all, or so many
  // as can be drawn, in no rhythm that another turn could share.
  const mostTurns = 24, firstTurns = 3, perTurn = 64;
  const mostShaded = Math.min(600, Math.max(40, Math.floor(600000 / (2 * count + 2) / followed.length / perTurn)));
  const isDense = (some) => turnsOf(some) > mostTurns;
  const denseNote = (some) => {
    const where = turnsOf(some) > mostShaded ? `where ${mostShaded} of them run` : 'where they run';
    return `Too many turns to be drawn one by one: the lines are the first ${firstTurns}, the shade is ${where}.`;
  };
  const momentsOf = (some) => {
    const turns = turnsOf(some);
    if (!isDense(some)) return {line: evenly(0, 1, Math.ceil(160 + perTurn * turns + 16 * exponentsOf(some))), shade: []};
    const line = evenly(0, firstTurns / turns, perTurn * firstTurns);
    if (turns <= mostShaded) return {line, shade: [evenly(0, 1, Math.ceil(perTurn * turns))]};
    const golden = (Math.sqrt(5) - 1) / 2;
    const begin = (k) => (k + golden * k % 1) / mostShaded * (1 - 1 / turns);
    return {
      line,
      shade: Array.from({length: mostShaded}, (_, k) => evenly(begin(k), begin(k) + 1 / turns, perTurn))
    };
  };

  // Round numbers that divide low to high into a few parts.
  const ticks = (low, high, most) => {
    const least = (high - low) / most, power = 10 ** Math.floor(Math.log10(least));
    const step = power * ([1, 2, 5].find((s) => s * power >= least * (1 - 1e-9)) || 10);
    const all = [];
    for (let k = Math.ceil(low / step); k * step <= high; ++k) all.push(k * step);
    return all;
  };

  // A window on the plane: where places come to stand on the paper.
  const view = (parent, places, label, wide, shapes) => {
    let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity;
    for (const [x, y] of places) x0 = Math.min(x0, x), x1 = Math.max(x1, x), y0 = Math.min(y0, y), y1 = Math.max(y1, y);
    const air = 0.08 * Math.max(x1 - x0, y1 - y0, unit);
    x0 -= air, x1 += air, y0 -= air, y1 += air;
    const shape = Math.min(shapes[1], Math.max(shapes[0], (y1 - y0) / (x1 - x0)));
    const high = Math.round(wide * shape), scale = Math.min(wide / (x1 - x0), high / (y1 - y0));
    const left = (x0 + x1) / 2 - wide / 2 / scale, top = (y0 + y1) / 2 + high / 2 / scale;
    const svg =
        put(parent, 'svg', {class: 'picture', viewBox: `0 0 ${wide} ${high}`, role: 'img', 'aria-label': label});
    const on = ([x, y]) => [(x - left) * scale, (top - y) * scale];
    const path = (ps, closed) =>
        'M' + ps.map((p) => on(p).map((v) => v.toFixed(1)).join(' ')).join('L') + (closed ? 'Z' : '');
    const grid = put(svg, 'g', {'stroke-width': 1, fill: 'none', 'aria-hidden': true});
    const marks = put(svg, 'g', {'aria-hidden': true});
    const rows = Math.max(2, Math.round(8 * high / wide)), columns = 8;
    for (const x of ticks(left, left + wide / scale, columns)) {
      const at = on([x, 0])[0];
      put(grid, 'path', {d: `M${at} 0V${high}`, stroke: Math.abs(x) < 1e-9 * unit ? 'var(--rule)' : 'var(--grid)'});
      if (at > 26 && at < wide - 26) put(marks, 'text', {x: at, y: high - 6, 'text-anchor': 'middle'}, number(x));
    }
    for (const y of ticks(top - high / scale, top, rows)) {
      const at = on([0, y])[1];
      put(grid, 'path', {d: `M0 ${at}H${wide}`, stroke: Math.abs(y) < 1e-9 * unit ? 'var(--rule)' : 'var(--grid)'});
      if (at > 14 && at < high - 22) put(marks, 'text', {x: 6, y: at + 4}, number(y));
    }
    return {svg, on, path};
  };

  const cross = (parent, stroke) =>
      put(parent, 'path', {d: 'M-7 0H7M0 -7V7', stroke, 'stroke-width': 2, fill: 'none', 'stroke-linecap': 'round'});
  const stand = (element, [x, y]) => element.setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
  const ghosts = [1, 2, 3, 4, 5, 6, 7, 8].map((k) => k / 8);

  // at: the matrix of t. options: moments; crosses: {colour, at, line}; dashed paths of another way: {at, line}.
  const draw = (parent, at, label, {moments, crosses = [], other, wide, shapes}) => {
    const way = moments.line.map(at);
    const shade = moments.shade.map((turn) => turn.map(at));
    const poses = ghosts.map(at);
    const places = corners.slice();
    for (const m of [way, ...shade].flat())
      for (const p of followed) places.push(moved(m, p.p));
    for (const m of poses)
      for (const p of corners) places.push(moved(m, p));
    const otherWay = other ? other.line.map(other.at) : [];
    for (const m of other ? [...otherWay, ...ghosts.map(other.at)] : [])
      for (const p of corners) places.push(moved(m, p));
    for (const c of crosses)
      for (let k = 0; k <= 32; ++k) places.push(c.at(k / 32));
    const v = view(parent, places, label, wide, shapes);
    const ink = (name, attributes) => put(v.svg, name, {fill: 'none', 'stroke-linejoin': 'round', ...attributes});
    if (shade.length > 0)
      followed.forEach((p, i) => ink('path', {
        d: shade.map((turn) => v.path(turn.map((m) => moved(m, p.p)))).join(''),
        stroke: followedColour(i),
        'stroke-width': 6,
        'stroke-opacity': 0.22
      }));
    for (const m of poses)
      ink('path', {d: v.path(figure.map((p) => moved(m, p)), true), stroke: 'var(--soft)', 'stroke-opacity': 0.35});
    ink('path', {d: v.path(figure, true), stroke: 'var(--soft)', 'stroke-dasharray': '4 3', 'stroke-width': 1.2});
    for (const c of crosses)
      if (c.line.length > 0)
        ink('path', {
          d: v.path(c.line.map(c.at)),
          stroke: c.colour,
          'stroke-dasharray': '1 4',
          'stroke-linecap': 'round',
          'stroke-width': 1.6
        });
    followed.forEach((p, i) => {
      ink('path', {d: v.path(way.map((m) => moved(m, p.p))), stroke: followedColour(i), 'stroke-width': 2});
      if (other)
        ink('path', {
          d: v.path(otherWay.map((m) => moved(m, p.p))),
          stroke: followedColour(i),
          'stroke-width': 2,
          'stroke-dasharray': '7 5'
        });
    });
    const second = other && ink('path', {stroke: 'var(--ink)', 'stroke-dasharray': '5 3', 'stroke-width': 1.4});
    const shape = ink('path', {fill: 'var(--ink)', 'fill-opacity': 0.14, stroke: 'var(--ink)', 'stroke-width': 1.6});
    const dots = followed.map(
        (_, i) => put(v.svg, 'circle', {r: 4.5, fill: followedColour(i), stroke: 'var(--panel)', 'stroke-width': 1.5}));
    const marks = crosses.map((c) => cross(v.svg, c.colour));
    pictures.push((t) => {
      const m = at(t);
      shape.setAttribute('d', v.path(figure.map((p) => moved(m, p)), true));
      if (other) second.setAttribute('d', v.path(figure.map((p) => moved(other.at(t), p)), true));
      dots.forEach((d, i) => stand(d, v.on(moved(m, followed[i].p))));
      marks.forEach((c, i) => stand(c, v.on(crosses[i].at(t))));
    });
  };

  // A centre is carried by the factors on its left.
  const carried = (some, first) => {
    const centres = [];
    some.forEach((f, i) => {
      if (f.kind === 'T') return;
      const over = some.slice(0, i);
      const at = (t) => moved(product(over, t), f.centre);
      centres.push({colour: colour(first + i), line: i > 0 ? momentsOf(over).line : [], at});
    });
    return centres;
  };

  // ---- The whole motion

  const spans = (parent, texts) => texts.map((text, i) => put(parent, 'span', {style: `color: ${colour(i)}`}, text));
  if (count > 0) {
    byId('string').textContent = '';
    spans(byId('string'), factors.map((f) => f.text));
  } else {
    byId('string').textContent = 'a motion of no factors';
  }
  const lead = () => {
    if (count === 0) return 'Nothing moves. Every method agrees.';
    if (count === 1) return 'A motion of one factor. T moves, R turns, S scales.';
    const first = factors[count - 1].text, last = factors[0].text;
    return `A motion of ${count} factors. Read it from the right: ${first} comes first, ${last} last. `
        + 'Each factor also moves the centres of those on its right.';
  };
  byId('lead').textContent = lead();

  draw(
      byId('stage'), motion, 'The figure at rest, on its way and at the end; the paths of its points',
      {moments: momentsOf(factors), crosses: carried(factors, 0), wide: 760, shapes: [0.4, 0.85]});
  const legend = byId('legend');
  const key = (parent, stroke, text, dashed) => {
    put(parent, 'span', {class: dashed ? 'key dashed' : 'key', style: `border-color: ${stroke}`});
    parent.append(text + ' ');
  };
  followed.forEach(
      (p, i) => key(
          legend, followedColour(i),
          (i < 2 ? `${p.name} of the figure, ${place(p.p)} at rest` : p.name) + (i + 1 < followed.length ? ';' : '.')));
  if (factors.some((f) => f.kind !== 'T'))
    legend.append('Crosses are centres, in the colours of their factors; dots show how they are carried. ');
  legend.append('Thin letters: every eighth part of the motion. ');
  if (isDense(factors)) legend.append(denseNote(factors));

  const now = spans(byId('now'), factors.map(() => ''));
  if (count === 0) byId('now').textContent = 'empty: the identity';
  const cells = [0, 1, 2].map(() => put(byId('matrix'), 'tr')).map((row) => [0, 1, 2].map(() => put(row, 'td')));
  pictures.push((t) => {
    const m = motion(t);
    [[m[0], m[2], m[4]], [m[1], m[3], m[5]]].forEach((row, r) => row.forEach((x, c) => {
      cells[r][c].textContent = fixed(x);
    }));
    ['0', '0', '1'].forEach((x, c) => {
      cells[2][c].textContent = x;
    });
    now.forEach((s, i) => {
      s.textContent = partly(factors[i], t);
    });
    byId('corner').textContent = `${place(tip)} → (${moved(m, tip).map(fixed).join(', ')})`;
  });

  // ---- One factor at a time

  const order = 'In the order in which they act on the figure, from the right of the string to its left. '
      + 'Each is shown alone first, and then after all those before it.';
  byId('factors-lead').textContent =
      ['There are none. An empty string is the identity at every t.', 'There is only one here.'][count] || order;
  for (let i = count - 1; i >= 0; --i) {
    const f = factors[i], card = put(byId('cards'), 'li');
    put(card, 'h3', {style: `color: ${colour(i)}`}, f.text);
    put(card, 'p', {}, described(f));
    const pair = put(card, 'div', {class: 'pair'});
    const one = (some, first, caption) => {
      const box = put(pair, 'figure');
      draw(
          box, (t) => product(some, t), `${caption}: ${some.map((s) => s.text).join(' ')}`,
          {moments: momentsOf(some), crosses: carried(some, first), wide: 460, shapes: [0.5, 0.75]});
      put(box, 'figcaption', {}, isDense(some) ? `${caption}. ${denseNote(some)}` : caption);
    };
    one([f], i, 'Alone');
    if (i < count - 1)
      one(factors.slice(i), i,
          i === 0 ? 'After all the others: the whole motion' : `After ${counted(count - 1 - i, 'factor', 'factors')}`);
  }

  // ---- Methods

  const means = {
    matrix: 'The points at rest, times the matrix of the step. Its numbers go on from step to step.',
    geometric: 'Points are pushed, grown and sheared where they are.',
    'geometric, linear law': 'The same for scalings by the linear law, for which the source counts it.',
    differences: 'One constant matrix, times the points of the step before.',
    best: 'The cheapest exact way that the string compiler finds.'
  };
  byId('ways-caption').textContent =
      `Counted for this string and ${lesson.steps} steps; the best way is sought for ${lesson.countedFor} points.`;
  for (const w of lesson.ways) {
    const row = put(byId('ways'), 'tr', w.name === 'best' ? {class: 'best'} : {});
    put(put(row, 'th', {scope: 'row'}, w.name), 'small', {}, means[w.name]);
    const cell = (label, text, note) => {
      const td = put(row, 'td', {class: 'number', 'data-label': label}, text);
      if (note) put(td, 'small', {}, note);
    };
    const printed = (part) => {
      if (!w.printed) return cell('The source:', '–');
      const after = part === 'before' && w.printed.after !== '0' ? `and ${w.printed.after} after the last step` : '';
      cell('The source:', w.printed[part], after);
    };
    if (w.refused) {
      const why = put(row, 'td', {class: 'refused', colspan: w.printed ? 1 : 4}, `Refuses: ${w.refused}.`);
      if (w.hint) put(why, 'small', {}, w.hint.replace(/`([^`]*)`/g, '“$1”'));
      if (!w.printed) continue;
      printed('step');
      cell('Before:', '–');
      printed('before');
      continue;
    }
    cell('Per step:', w.step, `each point: ${w.does}`);
    printed('step');
    cell(
        'Before:', w.before,
        w.functions ? `and ${counted(w.functions, 'sine or the like', 'sines and the like')}` : '');
    printed('before');
  }
  const able = lesson.ways.filter((w) => !w.refused);
  const most = Math.max(
      1, ...lesson.ways.flatMap((w) => [w.operations || 0, w.printed && !w.refused ? w.printed.operations : 0]));
  put(byId('bars'), 'p', {class: 'label'},
      `Operations per step for ${lesson.countedFor} points. Dashed: as the source prints.`);
  for (const w of able) {
    const row = put(byId('bars'), 'div', w.name === 'best' ? {class: 'best'} : {});
    put(row, 'span', {}, w.name);
    const bars = put(row, 'i');
    const bar = (n, name) => {
      const b = put(bars, 'b', {class: name});
      put(b, 'span', {style: `width: ${(100 * n / most).toFixed(2)}%`});
      put(b, 'em', {}, grouped(n));
    };
    bar(w.operations, 'ours');
    if (w.printed) bar(w.printed.operations, 'printed');
  }

  // ---- Drift

  const drifting = able.filter((w) => w.f32.alone.length > 0);
  byId('drift-steps').textContent = grouped(lesson.driftSteps);
  const rank = (name) => ['matrix', 'geometric', 'differences', 'best'].indexOf(name.split(',')[0]);
  const methodColour = (name) => `var(--m${rank(name)})`;
  const methodWidth = (name) => [4.5, 3.4, 2.4, 1.6][rank(name)];  // where lines meet, each is seen
  const driftPicture = (kind, low, high) => {
    const box = put(byId('drifts'), 'figure'), wide = 460, tall = 300, left = 52, right = 16, top = 16, below = 34;
    const svg = put(box, 'svg', {
      class: 'picture',
      viewBox: `0 0 ${wide} ${tall}`,
      role: 'img',
      'aria-label':
          `Largest distance so far in ${kind} against steps, both by powers of ten; the numbers are in the table below`
    });
    const x = (step) => left + Math.log10(step) / Math.log10(lesson.driftSteps) * (wide - left - right);
    const y = (d) => tall - below
        - (Math.log10(Math.min(Math.max(d, 10 ** low), 10 ** high)) - low) / (high - low) * (tall - top - below);
    for (let p = low; p <= high; p += 2) {
      put(svg, 'path', {d: `M${left} ${y(10 ** p)}H${wide - right}`, stroke: 'var(--grid)'});
      put(svg, 'text', {x: left - 8, y: y(10 ** p) + 4, 'text-anchor': 'end'},
          p === 0 ? '1' : `1e${p}`.replace('-', '−'));
    }
    for (let s = 1; s <= lesson.driftSteps; s *= 10) {
      const anchor = s === 1 ? 'start' : s === lesson.driftSteps ? 'end' : 'middle';
      const label = s === 1 ? '1 step' : s >= 1000 ? `${s / 1000}k` : s;
      put(svg, 'text', {x: x(s), y: tall - 12, 'text-anchor': anchor}, label);
    }
    const places = lesson.marks.map(x);
    for (const w of drifting)
      for (const how of ['renewed', 'alone'])
        put(svg, 'path', {
          fill: 'none',
          stroke: methodColour(w.name),
          'stroke-width': methodWidth(w.name),
          'stroke-linejoin': 'round',
          'stroke-dasharray': how === 'alone' ? 'none' : '3 4',
          d: 'M'
              + w[kind][how]
                    .map((d, i) => `${places[i].toFixed(1)} ${y(d === null ? 10 ** high : d).toFixed(1)}`)
                    .join('L')
        });
    const caption = put(box, 'figcaption', {}, `${kind}. `);
    for (const w of drifting) key(caption, methodColour(w.name), w.name);
  };
  const all =
      drifting.flatMap((w) => ['f32', 'f64'].flatMap((k) => [...w[k].alone, ...w[k].renewed])).filter((d) => d > 0);
  const even = (p) => 2 * Math.floor(p / 2);
  const lowest = Math.min(-16, even(Math.log10(Math.min(1, ...all))));
  const highest = Math.max(0, even(Math.log10(Math.max(1, ...all))) + 2);
  if (all.length > 0)
    for (const kind of ['f32', 'f64']) driftPicture(kind, Math.max(lowest, -24), Math.min(highest, 12));
  byId('drift-none').hidden = all.length > 0;
  const lost = drifting.some((w) => !(w.f32.alone.at(-1) <= 100 * w.f32.renewed.at(-1)));
  byId('drift-why').hidden = !(lost && turnsOf(factors) > 0);
  for (const w of drifting) {
    const row = put(byId('losses'), 'tr', w.name === 'best' ? {class: 'best'} : {});
    put(row, 'th', {scope: 'row'}, w.name);
    for (const kind of ['f32', 'f64'])
      for (const how of ['alone', 'renewed'])
        put(row, 'td', {class: 'number', 'data-label': `${kind}, ${how === 'alone' ? 'left alone' : how}:`},
            tiny(w[kind][how].at(-1)));
  }

  // ---- Other ways to the same end

  const paths = lesson.paths.filter((p) => p.kind !== 'no root');
  byId('paths-none').hidden = lesson.paths.length > 0;
  byId('paths-lead').hidden = paths.length === 0;
  byId('no-root').hidden = paths.length === lesson.paths.length;
  const lookup = (frames) => (t) => {
    const at = t * (frames.length - 1), k = Math.min(frames.length - 2, Math.floor(at)), part = at - k;
    return frames[k].map((x, i) => x + part * (frames[k + 1][i] - x));
  };
  for (const p of paths) {
    const box = put(byId('paths'), 'div', {class: 'path'}), picture = put(box, 'figure'), words = put(box, 'div');
    words.append(byId(`path-${p.kind}`).content.cloneNode(true));
    const moments = momentsOf(factors);
    let other = null;
    if (p.frames) other = {at: lookup(p.frames), line: evenly(0, 1, p.frames.length - 1)};
    if (p.kind === 'law') other = {at: (t) => product(factors, t, true), line: moments.line};
    if (other)
      draw(
          picture, (t) => product(factors, t, p.base === 'linear'), words.querySelector('h3').textContent,
          {moments, other, wide: 560, shapes: [0.5, 0.9]});
    if (isDense(factors))
      put(picture, 'figcaption', {}, other ? denseNote(factors) : 'These are too many turns for this way to be drawn.');
    const most = `The largest distance: ${number(p.gap, 3)}, at t = ${number(p.at, 3)}.`;
    put(words, 'p', {class: 'small'}, `${most} The letter is ${number(1.5 * unit)} high.`);
  }

  // ---- Now you

  byId('command').textContent = `betwixt algebra --lesson lesson.html "${lesson.text}"`;

  // What this page computes, beside what the program computed.
  const apart = Math.max(...lesson.frames.map((frame, k) => {
    const own = motion(k / (lesson.frames.length - 1));
    return Math.max(...frame.map((x, i) => Math.abs(own[i] - x) / Math.max(1, Math.abs(x))));
  }));
  document.documentElement.dataset.apart = apart;
  byId('checked').textContent =
      `This page works out A(t) by itself; at ${lesson.frames.length} moments it was compared with the ` +
      `program, and differs by ${apart === 0 ? 'nothing' : `at most ${tiny(apart)}`}.`;

  // ---- Time

  const slider = byId('time'), shown = byId('shown'), play = byId('play'), icon = byId('play-icon');
  const seconds = Math.min(20, 5 + turnsOf(factors));
  let t = 0, playing = null;
  const show = (to) => {
    t = Math.min(1, Math.max(0, to));
    slider.value = t;
    shown.textContent = `t = ${t.toFixed(3)}`;
    slider.setAttribute('aria-valuetext', `t = ${t.toFixed(3)}`);
    for (const update of pictures) update(t);
    document.documentElement.dataset.t = t;
  };
  const stop = () => {
    playing = null;
    play.setAttribute('aria-label', 'Play');
    icon.setAttribute('d', 'M7 4l13 8-13 8z');
  };
  const start = () => {
    if (t >= 1) show(0);
    const from = {};
    playing = from;
    play.setAttribute('aria-label', 'Pause');
    icon.setAttribute('d', 'M6 4h4v16H6zM14 4h4v16h-4z');
    let before = null;
    const tick = (time) => {
      if (playing !== from) return;
      if (before !== null) show(t + (time - before) / 1000 / seconds);
      before = time;
      if (t < 1)
        requestAnimationFrame(tick);
      else
        stop();
    };
    requestAnimationFrame(tick);
  };
  const toggle = () => playing ? stop() : start();
  play.addEventListener('click', toggle);
  slider.addEventListener('input', () => {
    stop();
    show(+slider.value);
  });
  slider.addEventListener('change', () => history.replaceState(null, '', `#t=${t.toFixed(3)}`));
  document.addEventListener('keydown', (e) => {
    if (e.key !== ' ' || e.target === play || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    toggle();
  });
  const fromAddress = () => {
    const asked = /^#t=([0-9.]+)$/.exec(location.hash);
    if (asked && Number.isFinite(+asked[1])) {
      stop();
      show(+asked[1]);
      return true;
    }
    return false;
  };
  addEventListener('hashchange', fromAddress);
  if (!fromAddress()) show(0);
})();
