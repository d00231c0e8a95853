// What a reader of a report does, in a browser.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import {
  browse,
  close,
  frame,
  goTo,
  legend,
  near,
  open,
  picture,
  place,
  plotBox,
  settle,
  time,
} from "./browser.mjs";
import { f32, page, report } from "./container.mjs";
import { bend, cantilever, frequencies, machine, modes, tip } from "./scenes.mjs";

let browser;
before(async () => {
  browser = await browse();
});
after(() => close(browser));

describe("a report from disk", () => {
  test("opens without a complaint and shows the body", async () => {
    const { tab, complaints, shown } = await open(browser, cantilever());
    assert.equal(shown, true);
    assert.deepEqual(complaints, []);
    assert.equal(await tab.$eval("h1", (e) => e.textContent), "cantilever");
    const share = await tab.evaluate(() => window.ancf.pixels());
    assert.ok(share > 0.01 && share < 0.9, `${share} of the picture`);
    await tab.close();
  });

  test("draws stations where the scene has them, between frames too", async () => {
    const { tab } = await open(browser, cantilever());
    for (const t of [0, 0.5, 0.775]) {
      await goTo(tab, t);
      const [x, y] = await place(tab, 0, 20);
      near(x, 0.5, 1e-6, "x");
      // Linear between frames 0.05 s apart: off by at most (0.05 π)² / 8 of the amplitude.
      near(y, bend(0.5, tip(t)), 0.25 * ((0.05 * Math.PI) ** 2 / 8), "y");
    }
    await tab.close();
  });

  test("the picture shows the body at the place that `station` gives", async () => {
    const { tab } = await open(browser, cantilever());
    await tab.keyboard.press("m");
    await tab.keyboard.press("l");
    const shots = [];
    for (const t of [0.5, 1.5]) {
      await goTo(tab, t);
      await settle(tab);
      const [x, y] = await tab.evaluate(() => window.ancf.spot(0, 38));
      const box = await (await tab.$("canvas[tabindex]")).boundingBox();
      const clip = { x: Math.round(box.x + x) - 3, y: Math.round(box.y + y) - 3, width: 6, height: 6 };
      shots.push([clip, Buffer.from(await tab.screenshot({ clip })).toString("base64")]);
      if (shots.length === 2) {
        // Where it was before there is now background: another picture.
        const [old, body] = shots[0];
        assert.notEqual(Buffer.from(await tab.screenshot({ clip: old })).toString("base64"), body);
      }
    }
    await tab.close();
  });

  test("plays: the tip moves, the picture and the line in the chart too", async () => {
    const { tab, complaints } = await open(browser, cantilever());
    const [first, start] = [await picture(tab), await place(tab, 0, 40)];
    const line = () => tab.$eval(".now", (e) => e.style.transform);
    const before = await line();
    await tab.keyboard.press("Space");
    await tab.waitForFunction(() => window.ancf.time > 0.2);
    assert.equal(await tab.evaluate(() => window.ancf.playing), true);
    await tab.keyboard.press("Space");
    assert.equal(await tab.evaluate(() => window.ancf.playing), false);
    const tipNow = await place(tab, 0, 40);
    near(tipNow[1], tip(await time(tab)), 2e-3, "tip");
    assert.notEqual(tipNow[1], start[1]);
    assert.notEqual(await picture(tab), first);
    assert.notEqual(await line(), before);
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("stands still until asked, for those who want less motion; else it plays", async () => {
    const calm = await open(browser, cantilever());
    assert.equal(await calm.tab.evaluate(() => window.ancf.playing), false);
    await calm.tab.close();
    const lively = await open(browser, cantilever(), { motion: "no-preference" });
    assert.equal(await lively.tab.evaluate(() => window.ancf.playing), true);
    await lively.tab.close();
  });

  test("draws nothing while nothing changes", async () => {
    const before = () => {
      window.draws = 0;
      const draw = WebGL2RenderingContext.prototype.drawElementsInstanced;
      WebGL2RenderingContext.prototype.drawElementsInstanced = function (...a) {
        window.draws += 1;
        return draw.apply(this, a);
      };
    };
    const { tab } = await open(browser, cantilever(), { before });
    await settle(tab);
    const drawn = await tab.evaluate(() => window.draws);
    await new Promise((done) => setTimeout(done, 400));
    assert.ok(drawn > 0);
    assert.equal(await tab.evaluate(() => window.draws), drawn);
    await tab.close();
  });

  test("is worked with keys", async () => {
    const { tab } = await open(browser, cantilever());
    const press = async (key, wanted) => {
      await tab.keyboard.press(key);
      assert.equal(await frame(tab), wanted, key);
    };
    await press("ArrowRight", 1);
    await press("ArrowRight", 2);
    await press("ArrowLeft", 1);
    await tab.keyboard.down("Shift");
    await press("ArrowRight", 11);
    await tab.keyboard.up("Shift");
    await press("End", 40);
    await press("Home", 0);
    const speed = async () => {
      await settle(tab);
      return await tab.$eval(".transport select", (e) => Number(e.value));
    };
    const before = await speed();
    await tab.keyboard.press("+");
    assert.ok((await speed()) > before);
    await tab.keyboard.press("-");
    assert.equal(await speed(), before);
    await tab.keyboard.press("?");
    assert.ok(await tab.$("dialog[open]"));
    await tab.keyboard.press("Escape");
    assert.equal(await tab.$("dialog[open]"), null);
    await tab.close();
  });

  test("each view, the ghost and the reactions change the picture", async () => {
    const { tab } = await open(browser, cantilever());
    await goTo(tab, 0.5);
    const seen = new Set([await picture(tab)]);
    for (const key of ["1", "2", "3", "4", ",", "z", "g", "r", "l", "n"]) {
      await tab.keyboard.press(key);
      seen.add(await picture(tab));
    }
    // The oblique view is the one of the beginning.
    assert.ok(seen.size >= 10, `${seen.size} different pictures`);
    await tab.close();
  });

  test("repeats the film where wanted", async () => {
    const { tab } = await open(browser, cantilever({ frames: 11, until: 0.5 }));
    await goTo(tab, 0.45);
    await tab.keyboard.press("o");
    await tab.keyboard.press("Space");
    await tab.waitForFunction(() => window.ancf.time < 0.3, { timeout: 20_000 });
    assert.equal(await tab.evaluate(() => window.ancf.playing), true);
    await tab.close();
  });

  test("scrubs with the slider", async () => {
    const { tab } = await open(browser, cantilever());
    const { x, y, width, height } = await (await tab.$(".scrub")).boundingBox();
    await tab.mouse.click(x + width / 2, y + height / 2);
    near(await time(tab), 1, 0.02, "time");
    await tab.close();
  });

  test("scales deformations from the reference", async () => {
    const { tab } = await open(browser, cantilever());
    await goTo(tab, 0.5);
    await tab.keyboard.press("d");
    const slider = 'input[aria-label="deformation"]';
    await tab.$eval(slider, (e) => {
      e.value = "1";
      e.dispatchEvent(new Event("input"));
    });
    const [x, y] = await place(tab, 0, 40);
    near(x, 1, 1e-6, "x");
    near(y, 10 * tip(0.5), 1e-5, "y");
    await tab.close();
  });

  test("colours by the chosen field, and says what the colours mean", async () => {
    const { tab } = await open(browser, cantilever());
    await goTo(tab, 0.25);
    const seen = [await picture(tab)];
    assert.match(await tab.$eval(".legend", (e) => e.textContent), /bending moment\s*N m.*75.*0.*−75/);
    await tab.keyboard.press("c");
    seen.push(await picture(tab));
    assert.match(await tab.$eval(".legend", (e) => e.textContent), /speed\s*m\/s.*0\.8/);
    await tab.keyboard.press("c");
    seen.push(await picture(tab));
    assert.equal(await tab.$eval(".legend", (e) => e.hidden), true);
    assert.equal(new Set(seen).size, 3);
    await tab.close();
  });

  test("a field that is not a number in places still colours the rest", async () => {
    const seen = [];
    for (const nan of [false, true]) {
      const { tab, complaints } = await open(browser, cantilever({ nan }));
      await goTo(tab, 0.5);
      seen.push(await picture(tab));
      assert.deepEqual(complaints, []);
      await tab.close();
    }
    assert.notEqual(seen[0], seen[1]);
  });

  test("names what is under the pointer, with its place and value", async () => {
    const { tab } = await open(browser, cantilever());
    await goTo(tab, 0.5);
    await settle(tab);
    const box = await (await tab.$("canvas[tabindex]")).boundingBox();
    const [x, y] = await tab.evaluate(() => window.ancf.spot(0, 20));
    await tab.mouse.move(box.x + x, box.y + y);
    await settle(tab);
    const text = await tab.$eval(".tip", (e) => (e.hidden ? "" : e.textContent));
    assert.match(text, /rod/);
    assert.match(text, /s = 0\.5 m of 1 m/);
    assert.match(text, /bending moment: −37\.5 N m/);
    await tab.mouse.move(box.x + 5, box.y + box.height - 5);
    await settle(tab);
    assert.equal(await tab.$eval(".tip", (e) => e.hidden), true);
    await tab.close();
  });
});

describe("other scenes", () => {
  test("shapes are listed, chosen and swing", async () => {
    const { tab, complaints } = await open(browser, modes());
    const labels = await tab.$$eval(".shape", (all) => all.map((e) => e.textContent));
    assert.deepEqual(labels, ["mode 1: 12.3 Hz", "mode 2: 77.1 Hz", "mode 3: 216 Hz"]);
    const still = await place(tab, 0, 40);
    near(still[0], 0.1, 1e-6, "the first shape at its largest");
    await tab.keyboard.press("Space");
    const seen = await tab.evaluate(async () => {
      const list = [];
      for (let i = 0; i < 60; i++) {
        await new Promise((done) => setTimeout(done, 40));
        list.push(window.ancf.station(0, 40)[0]);
      }
      return list;
    });
    assert.ok(Math.min(...seen) < -0.05 && Math.max(...seen) > 0.05, "to both sides");
    await tab.keyboard.press("Space");
    const buttons = await tab.$$(".shape");
    await buttons[2].click();
    assert.equal(await frame(tab), 2);
    await settle(tab);
    assert.equal(await buttons[2].evaluate((b) => b.getAttribute("aria-pressed")), "true");
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("shapes have six digits or are rigid; their charts are points that can be chosen", async () => {
    const { tab, complaints } = await open(browser, frequencies());
    const labels = await tab.$$eval(".shape", (all) => all.map((e) => e.textContent));
    assert.deepEqual(labels, ["mode 1: rigid", "mode 2: 77.1234 Hz", "mode 3: 216.001 Hz"]);
    assert.equal(await frame(tab), 1, "the first that is not rigid");
    await tab.click("#tab-Charts");
    await settle(tab);
    near(await legend(tab, "frequency"), 77.12, 1e-9, "frequency");
    assert.equal(await tab.$eval(".now", (e) => e.hidden), false);
    const { left, top, width, height } = await plotBox(tab);
    await tab.mouse.click(left + 0.8 * width, top + height / 2);
    assert.equal(await frame(tab), 2);
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("reactions at one place are all told, in two lines where there is no room for one", async () => {
    const scene = cantilever();
    const [root] = scene.markers;
    const [reaction] = scene.reactions;
    scene.markers.push({ ...root, name: "second" });
    const noise = f32(new Array(3 * 41).fill(1e-15));
    scene.reactions.push({ ...reaction, name: "second", marker: 2 });
    scene.markers.push({ ...root, name: "third" });
    scene.reactions.push({ name: "third", marker: 3, force: noise, moment: noise });
    const { tab, complaints } = await open(browser, scene);
    await goTo(tab, 0.5);
    await settle(tab);
    const found = await tab.$$eval(".labels .reaction:not([hidden])", (all) => all.map((e) => e.textContent));
    assert.deepEqual(found, ["F 10 N, M 75 N m", "F 10 N\nM 75 N m"]);
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("colours of rounding noise stand for zero", async () => {
    const scene = cantilever();
    const [, speed] = scene.fields;
    scene.fields = [
      { ...speed, range: [1e-17, 0.8] },
      { ...speed, name: "drift", range: [0, 1e-15] },
    ];
    const { tab } = await open(browser, scene);
    const seen = () => tab.$$eval(".legend li", (all) => all.map((e) => e.textContent));
    assert.deepEqual(await seen(), ["0.8", "0.6", "0.4", "0.2", "0"]);
    await tab.keyboard.press("c");
    await settle(tab);
    assert.deepEqual(await seen(), ["0", "0", "0", "0", "0"]);
    await tab.close();
  });

  test("the program is named once", async () => {
    const scene = cantilever();
    scene.summary.push(["program", "ancf 0.1.0 on 8 cores"]);
    const { tab } = await open(browser, scene);
    const rows = await tab.$$eval(".run th", (all) => all.map((e) => e.textContent));
    assert.equal(rows.filter((name) => name === "program").length, 1);
    await tab.close();
  });

  test("a failed run says so first; obstacles, links and rigid bodies are drawn", async () => {
    const { tab, complaints } = await open(browser, machine());
    assert.match(await tab.$eval(".banner", (e) => e.textContent), /no equilibrium at t = 1 s/);
    assert.equal(await time(tab), 1, "where it failed");
    assert.equal(await tab.evaluate(() => window.ancf.playing), false);
    await tab.click("#tab-Run");
    assert.match(await tab.$eval(".messages", (e) => e.textContent), /touches the floor/);
    assert.ok((await tab.evaluate(() => window.ancf.pixels())) > 0.2);
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("a single frame, and none at all", async () => {
    const one = await open(browser, cantilever({ frames: 1 }));
    assert.ok((await one.tab.evaluate(() => window.ancf.pixels())) > 0.01);
    assert.equal(await one.tab.$eval(".primary", (e) => e.disabled), true);
    assert.deepEqual(one.complaints, []);
    await one.tab.close();
    const none = await open(browser, { ...machine(), ...emptyFrames() });
    assert.match(await none.tab.$eval(".nothing", (e) => e.textContent), /nothing to draw/);
    assert.deepEqual(none.complaints, []);
    await none.tab.close();
  });

  test("data that are cut, foreign or missing give a sentence", async () => {
    const whole = report(cantilever());
    const data = whole.match(/id="scene">([^<]*)</)[1];
    const cases = [data.slice(0, data.length >> 1), Buffer.from("a text").toString("base64"), "@@@", ""];
    for (const text of cases) {
      const { tab, complaints, shown } = await open(browser, null, { html: page(text) });
      assert.equal(shown, false);
      assert.match(
        await tab.$eval(".banner", (e) => e.textContent),
        /^(The data of this page|This page holds)/,
      );
      assert.deepEqual(complaints, []);
      await tab.close();
    }
  });

  test("without WebGL 2 the charts are there and a sentence says what is missing", async () => {
    const before = () => {
      const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind === "webgl2" ? null : get.call(this, kind, ...more);
      };
    };
    const { tab, complaints } = await open(browser, cantilever(), { before });
    assert.match(await tab.$eval(".nothing", (e) => e.textContent), /WebGL 2/);
    await goTo(tab, 0.5);
    await settle(tab);
    near(await legend(tab, "y"), tip(0.5), 1e-3, "y");
    assert.deepEqual(complaints, []);
    await tab.close();
  });
});

function emptyFrames() {
  const none = cantilever({ frames: 0 });
  return {
    frames: none.frames,
    centres: none.centres,
    directors: none.directors,
    markers: [],
    links: [],
    charts: [],
  };
}
