# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the sound of films in pages: the samples are those of the film that the program renders, each is given to the
# browser's audio clock at its time, and the picture follows that clock. Skipped if the player is not built.
#   sound_test.py PROGRAM [SECONDS]    SECONDS: how long the drift is watched (by default 4)
import array, json, math, os, random, subprocess, sys, tempfile, wave
from browser import Browser, Served
from checks import check, done, player, same, there_is_a_player

program = os.path.abspath(sys.argv[1])
long = float(sys.argv[2]) if len(sys.argv) > 2 else 4
there_is_a_player()
folder_of_test = tempfile.TemporaryDirectory()
folder = folder_of_test.name
environment = {**os.environ, "BETWIXT_PLAYER": player}
head = "rate 24\nrange 1f 48f\nsize 64x36\nfilm flat\ncreate ball circle radius=3 color=red\n"
films = {
    "music": head + 'create music sound file="noise.wav" from=0.25s fade-in=0.1s\nset music.at 7f\n'
                    'create voice sound file="voice.wav" fade-out=0.2s\nmusic.gain\n  1f 0.2\n  30f 0.7 linear\n',
    "voice": head.replace("48f", "24f") + 'create voice sound file="voice.wav"\nset ball.radius = "5 * value(\'voice.loudness\')"\n',
    "other": head + 'create hiss sound file="hiss.wav"\n',
    "packed": head + 'create music sound file="noise.flac"\n',
    "broken": head + 'create music sound file="broken.wav"\n',
}
# What a page gives to the audio clock, and when; and how many files it decodes.
spy = """window.given = []; window.decoded = 0; const decode = BaseAudioContext.prototype.decodeAudioData;
  BaseAudioContext.prototype.decodeAudioData = function (...all) { ++decoded; return decode.apply(this, all); };
  const start = AudioBufferSourceNode.prototype.start;
  AudioBufferSourceNode.prototype.start = function (at) { given.push([at, this.buffer, this]); window.ctx = this.context; return start.call(this, at); };
  const stop = AudioBufferSourceNode.prototype.stop; AudioBufferSourceNode.prototype.stop = function (at) { window.stops = (window.stops ?? 0) + 1; return stop.call(this, at); };"""
helpers = """window.p = document.querySelector("betwixt-player"); window.wait = (ms) => new Promise((r) => setTimeout(r, ms));
  window.until = (m, name) => new Promise((r) => m.addEventListener(name, r, { once: true }));
  window.heard = () => given.filter(([,, s]) => s.context.currentTime >= 0).length;
  window.told = (from, count) => { const s = p.film.sound(from, count), out = []; for (let i = 0; i < count; ++i) out.push(s.left[i], s.right[i]); return out; };"""


def sounds():
    dice = random.Random(7)
    def write(name, channels, rate, samples):
        with wave.open(f"{folder}/{name}", "wb") as out:
            out.setnchannels(channels), out.setsampwidth(2), out.setframerate(rate)
            out.writeframes(array.array("h", samples).tobytes())
    write("noise.wav", 2, 48000, [dice.randint(-20000, 20000) for _ in range(2 * 96000)])
    write("voice.wav", 1, 48000, [round(15000 * math.sin(i * i / 9e4)) for i in range(72000)])
    write("hiss.wav", 1, 22050, [round(9000 * math.sin(i / 9) + 5000 * math.sin(i / 31)) for i in range(33075)])
    subprocess.run(["ffmpeg", "-v", "error", "-i", f"{folder}/noise.wav", f"{folder}/noise.flac"], check=True)
    with open(f"{folder}/broken.wav", "w") as out:
        out.write("no sound at all")


# Returns the samples of the film's sound track, as the program renders it: left and right alternately.
def rendered(name):
    subprocess.run([program, "render", f"{name}.bx", "-o", f"{name}.mov"], cwd=folder, check=True, capture_output=True)
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", f"{folder}/{name}.mov", "-f", "f32le", "-"], check=True, capture_output=True).stdout
    return array.array("f", raw)


def opened(browser, url):
    page = browser.page()
    page.call("Page.addScriptToEvaluateOnNewDocument", source=spy)
    page.go(url)
    page.do(helpers)
    return page


def apart(one, other):
    return max(map(abs, map(float.__sub__, map(float, one), map(float, other)))) if len(one) == len(other) else math.inf


def samples(browser):
    # At the ends of a file with another rate, the filters that convert it differ.
    for name, edge in (("music", 0), ("packed", 0), ("other", 200)):
        page, wanted = opened(browser, f"file://{folder}/{name}.html"), rendered(name)
        page.until("p.readyState === 4")
        found = page.ask(f"told(0, {len(wanted) // 2})")
        check(f"{name}: not silent", max(map(abs, wanted)) > 0.1)
        length = 144000 if edge else len(wanted)  # the hiss ends before the film
        inner = slice(edge, length - edge)
        check(f"{name}: the samples of the film", apart(found[inner], wanted[inner]) < 1e-4, apart(found[inner], wanted[inner]))
        same(f"{name}: from any place", page.ask("told(30000, 1000)"), found[60000:62000])
        page.close()


# Puts what was given to the clock together, as it is heard, and compares it with the film's samples, from the first.
def scheduled(page):
    return page.ask("""(() => { const first = given[0][0], out = new Float32Array(96000); let gap = 0, next = first;
      for (const [at, b] of given) { gap = Math.max(gap, Math.abs(at - next)), next = at + b.length / 48000;
        const place = Math.round((at - first) * 48000); if (place < 48000) out.set(b.getChannelData(0).subarray(0, 96000 - place), place); }
      const whole = p.film.sound(0, 48000).left; let most = 0; for (let i = 0; i < 48000; ++i) most = Math.max(most, Math.abs(out[i] - whole[i]));
      return { gap, most, loud: Math.max(...whole.slice(0, 9000).map(Math.abs)), rate: given[0][1].sampleRate }; })()""")


def in_time(browser):
    page = opened(browser, f"file://{folder}/music.html")
    page.until("p.readyState === 4")
    page.do("p.pause(); p.currentTime = 0; await until(p, 'seeked'); given.length = 0; await p.play(); await wait(1500);")
    found = scheduled(page)
    check("each sample follows the one before", found["gap"] < 1e-6, found)
    check("what is heard is the film's sound", found["most"] == 0 and found["rate"] == 48000 and found["loud"] > 0.1, found)
    # The picture's time, and that of the audio clock.
    watch = """(async () => { const all = []; for (let i = 0; i < COUNT; ++i) { await wait(100);
      const t = ctx.getOutputTimestamp(), now = t.performanceTime > 0 ? t.contextTime + (performance.now() - t.performanceTime) / 1000 : ctx.currentTime;
      all.push(Math.min(now, ctx.currentTime) - given[0][0] - p.currentTime); } return all; })()"""
    page.do("p.pause(); p.currentTime = 0; await until(p, 'seeked'); given.length = 0; await p.play(); await wait(300);")
    drift = [d - 2 * round(d / 2) for d in page.ask(watch.replace("COUNT", str(int(long * 10))), long + 60)]
    # A busy machine may hold single moments up.
    late = sorted(map(abs, drift))
    check("the picture is in time with the sound", late[len(late) // 2] < 0.01 and late[int(0.8 * len(late))] < 1 / 24,
          (min(drift), max(drift)))
    print(f"  picture minus sound: {1000 * min(drift):.1f} to {1000 * max(drift):.1f} ms in {long:.0f} s")
    page.do("await p.pause(); window.stops = 0; given.length = 0; await wait(400);")
    same("a film that stands gives no sound", page.ask("given.length"), 0)
    page.do("p.currentTime = 0.5; p.playbackRate = 2; await until(p, 'seeked'); await p.play(); await wait(400);")
    twice = page.ask("""(() => { const b = given[0][1].getChannelData(0), whole = p.film.sound(24000, 24000).left; let most = 0;
      for (let i = 0; i < 12000; ++i) most = Math.max(most, Math.abs(b[i] - whole[2 * i])); return most; })()""")
    check("twice as fast, it takes every second sample", twice < 1e-6, twice)
    page.do("p.playbackRate = -1; await wait(100); given.length = 0; await wait(500);")
    same("backwards it is silent", page.ask("given.length"), 0)
    page.close()


def as_a_video(browser):
    page = opened(browser, f"file://{folder}/music.html")
    page.until("p.readyState === 4")
    same("at first", page.ask("[p.muted, p.volume, p.defaultMuted]"), [False, 1, False])
    page.do("await p.play(); await wait(200); window.events = 0; p.addEventListener('volumechange', () => ++events); p.muted = true; given.length = 0; await wait(600);")
    same("muted, nothing is given", page.ask("[given.length, events, p.paused]"), [0, 1, False])
    before = page.ask("p.currentTime")
    page.do("p.muted = false; await wait(600);")
    check("it joins the picture", page.ask("given.length") > 0)
    check("which has gone on", page.ask("p.currentTime") != before)
    page.do("p.volume = 0.25")
    same("volume", page.ask("[p.volume, events]"), [0.25, 3])
    same("wrong volumes", page.ask("[2, -1, NaN].map((v) => { try { p.volume = v } catch (e) { return e.name } })"), ["IndexSizeError", "IndexSizeError", "TypeError"])
    button = "p.shadowRoot.querySelector('[data-do=mute]')"
    same("the button", page.ask(f"[{button}.hidden, {button}.title]"), [False, "Sound off"])
    page.do(f"{button}.click()")
    same("mutes", page.ask(f"[p.muted, {button}.title]"), [True, "Sound on"])
    page.do("p.focus(); p.dispatchEvent(new KeyboardEvent('keydown', { key: 'm', bubbles: true, composed: true }))")
    same("and so does m", page.ask("p.muted"), False)
    page.do("p.setAttribute('muted', ''); p.setAttribute('volume', '0.5')")
    same("attributes", page.ask("[p.muted, p.volume, p.defaultMuted]"), [True, 0.5, True])
    page.do("await p.pause(); p.script = p.script.replace(/create (music|voice).*/g, '').replace(/(set )?music.*\\n(  .*\\n)*/g, ''); await wait(200);")
    same("a silent film has no button", page.ask(f"[p.film.sounds, {button}.hidden]"), [False, True])
    page.close()


def loops_and_several(browser):
    page = opened(browser, f"file://{folder}/several.html")
    page.until("[...document.querySelectorAll('betwixt-player')].every((p) => p.readyState === 4)")
    page.do("""window.both = [...document.querySelectorAll('betwixt-player')]; p = both[1]; for (const one of both) { one.pause(); one.currentTime = 0; }
      await wait(200); given.length = 0; p.currentTime = 0.9; await until(p, 'seeked'); await p.play(); await wait(700);""")
    joined = page.ask("""(() => { const b = [...given[0][1].getChannelData(0)], whole = p.film.sound(0, 24000).left, first = Math.round(0.9 * 48000); let most = 0;
      for (let i = 0; i < 12000; ++i) { const at = (first + i) % 48000; most = Math.max(most, Math.abs(b[i] - (at < 24000 ? whole[at] : p.film.sound(at, 1).left[0]))); } return most; })()""")
    same("across its end, a loop goes on with its first sample", joined, 0)
    alone = page.ask("given.length")
    page.do("await both[0].play(); await wait(700);")
    same("each file is decoded once", page.ask("decoded"), 2)
    same("two players are heard in one clock", page.ask("new Set(given.map(([,, s]) => s.context)).size"), 1)
    check("both of them", page.ask("given.length") > alone + 3)
    wanted = json.loads(subprocess.run([program, "eval", "voice.bx", "--at", "0.5s", "ball.radius", "--json"], cwd=folder, capture_output=True, text=True).stdout)["times"][0]["values"]["ball.radius"]
    found = page.ask("p.eval('ball.radius', 0.5)")
    check("loudness is known", wanted > 0.5 and abs(found - wanted) < 1e-4, (found, wanted))
    page.close()


# A clock that stands still, as of a browser without a sound device; and no clock at all.
def no_device(browser):
    still = """for (const name of ["currentTime", "outputLatency"]) Object.defineProperty(BaseAudioContext.prototype, name, { get: () => 0 });
      AudioContext.prototype.getOutputTimestamp = () => ({ contextTime: 0, performanceTime: 0 });"""
    for name, how in (("a clock that stands", still), ("no clock", "AudioContext = class { constructor() { throw new Error('no') } };")):
        page = browser.page()
        page.call("Page.addScriptToEvaluateOnNewDocument", source=how)
        page.go(f"file://{folder}/music.html")
        page.do(helpers)
        page.until("p.readyState === 4")
        page.do("p.loop = false; p.pause(); p.currentTime = 0; await until(p, 'seeked'); await p.play(); await wait(2000);")
        at = page.ask("p.currentTime")
        check(f"{name}: the film plays on", at > 0.7, at)
        page.close()


def wrong_files(browser, served):
    page = opened(browser, f"{served}/wrong.html")
    page.until("p.error")
    check("a file that is no sound is said to be none", "broken.wav" in page.ask("p.error.message") and ":6:" in page.ask("p.error.message"), page.ask("p.error.message"))
    page.close()


# No gesture: page.ask would be one, so this looks at the page by a call without it.
def untouched():
    with Browser("--autoplay-policy=document-user-activation-required") as browser:
        page = browser.page()
        page.call("Page.addScriptToEvaluateOnNewDocument", source=spy)
        page.go(f"file://{folder}/music.html")
        look = lambda what: page.call("Runtime.evaluate", expression=what, awaitPromise=True, returnByValue=True, userGesture=False)["result"].get("value")
        look("new Promise((r) => setInterval(() => document.querySelector('betwixt-player').readyState === 4 && r(), 50))")
        look("new Promise((r) => setTimeout(r, 1000))")
        same("before the page is touched it plays silently", look("(() => { const p = document.querySelector('betwixt-player'); return [p.paused, p.muted, given.length, p.shadowRoot.querySelector('[data-do=mute]').title]; })()"), [False, False, 0, "Sound on"])
        same("and says nothing of it", page.said, [])
        page.mouse("mousePressed", 5, 5), page.mouse("mouseReleased", 5, 5)
        look("new Promise((r) => setTimeout(r, 900))")
        check("then it sounds", look("given.length") > 0)


sounds()
for name, text in films.items():
    with open(f"{folder}/{name}.bx", "w") as out:
        out.write(text)
for call in (["music.bx"], ["packed.bx"], ["other.bx"], ["music.bx", "voice.bx", "-o", "several.html"]):
    said = subprocess.run([program, "web", *call], cwd=folder, env=environment, capture_output=True, text=True)
    same(f"{call[0]}: nothing is lost", "notice" in said.stderr, False)
with open(f"{folder}/wrong.html", "w") as out:
    out.write(f"<!doctype html><script src=player.js></script><betwixt-player controls loading=eager src=broken.bx></betwixt-player>")
os.symlink(player, f"{folder}/player.js")
with Browser() as browser, Served(folder) as served:
    for part, *given in ((samples,), (in_time,), (as_a_video,), (loops_and_several,), (no_device,), (wrong_files, served)):
        try:
            part(browser, *given)
        except Exception as e:
            check(part.__name__, False, e)
untouched()
done()
