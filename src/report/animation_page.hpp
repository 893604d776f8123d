#pragma once

namespace limber {

/// The page around an animation's data: @TITLE@ and @DATA@ are put in by animation.cpp.
inline constexpr const char* kAnimationPage = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>@TITLE@</title>
<style>
  body { font: 15px system-ui, sans-serif; margin: 1em auto; max-width: 900px; padding: 0 1em;
         color: #222; background: #fff; }
  canvas { border: 1px solid #ccc; background: #fff; }
  .row { display: flex; gap: .8em; align-items: center; margin: .5em 0; flex-wrap: wrap; }
  input[type=range] { flex: 1; min-width: 12em; }
  #setpoints { font-variant-numeric: tabular-nums; white-space: pre-wrap; }
  .key { display: inline-block; width: .9em; height: .9em; border-radius: .2em; }
</style>
</head>
<body>
<h1 style="font-size: 1.2em">@TITLE@</h1>
<canvas id="world" aria-label="the arm among the obstacles"></canvas>
<div class="row">
  <button id="play">pause</button>
  <input id="time" type="range" min="0" value="0" step="1" aria-label="frame"/>
  <span id="clock"></span>
  <label>speed <select id="speed">
    <option>0.25</option><option>0.5</option><option selected="selected">1</option>
    <option>2</option><option>4</option></select></label>
</div>
<div class="row" id="legend"></div>
<div id="setpoints"></div>
<script id="data" type="application/json">@DATA@</script>
<script>
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const canvas = document.getElementById("world");
const paper = canvas.getContext("2d");
const slider = document.getElementById("time");
const box = data.box;
const frames = Math.max(...data.tracks.map((track) => track.shapes.length));
slider.max = frames - 1;
let at = 0, playing = true, before = null, scale = 1;

function resize() {
  const slope = (box.y_max - box.y_min) / (box.x_max - box.x_min);
  const ratio = window.devicePixelRatio || 1;
  const width = Math.min(document.body.clientWidth - 34, 0.72 * window.innerHeight / slope);
  const height = width * slope;
  canvas.style.width = width + "px";
  canvas.style.height = height + "px";
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  scale = canvas.width / (box.x_max - box.x_min);
  draw();
}
const x = (value) => (value - box.x_min) * scale;
const y = (value) => (box.y_max - value) * scale;

function outline(points) {
  paper.beginPath();
  points.forEach(([px, py], i) => i ? paper.lineTo(x(px), y(py)) : paper.moveTo(x(px), y(py)));
}
function disc(px, py, radius) {
  paper.beginPath();
  paper.arc(x(px), y(py), radius * scale, 0, 2 * Math.PI);
}
function drawWorld() {
  paper.clearRect(0, 0, canvas.width, canvas.height);
  paper.fillStyle = "#9a9a9a";
  for (const o of data.obstacles) {
    if (o.points) { outline(o.points); paper.closePath(); } else { disc(o.x, o.y, o.radius); }
    paper.fill();
  }
  const goal = data.goal;
  paper.fillStyle = "rgba(0, 158, 115, 0.35)";
  disc(goal.x, goal.y, goal.tolerance);
  paper.fill();
  paper.fillStyle = "#009e73";
  paper.beginPath();
  for (let k = 0; k < 10; ++k) {
    const r = (k % 2 ? 0.4 : 1) * 0.016, a = Math.PI / 2 + k * Math.PI / 5;
    paper.lineTo(x(goal.x + r * Math.cos(a)), y(goal.y + r * Math.sin(a)));
  }
  paper.fill();
  if (goal.theta !== null) {
    paper.strokeStyle = "#00523c";
    paper.lineWidth = 2;
    outline([[goal.x, goal.y],
             [goal.x + 0.07 * Math.cos(goal.theta), goal.y + 0.07 * Math.sin(goal.theta)]]);
    paper.stroke();
  }
}
function drawTrack(track, k) {
  const last = track.shapes.length - 1;
  const shape = track.shapes[Math.min(k, last)];
  paper.strokeStyle = track.color;
  paper.lineWidth = 1.5;
  paper.globalAlpha = 0.7;
  outline(track.shapes.slice(0, Math.min(k, last) + 1).map((s) => s[s.length - 1]));
  paper.stroke();
  paper.globalAlpha = 0.55;
  paper.lineCap = "round";
  paper.lineJoin = "round";
  for (let first = 0; first < data.radii.length;) {  // a stroke a thickness: opacity adds up once
    let end = first;
    while (end < data.radii.length && data.radii[end] === data.radii[first]) ++end;
    paper.lineWidth = 2 * data.radii[first] * scale;
    outline(shape.slice(first, end + 1));
    paper.stroke();
    first = end;
  }
  paper.globalAlpha = 1;
  paper.fillStyle = "#222";
  for (const [px, py] of shape) { disc(px, py, 0.003); paper.fill(); }
}
function row(name, rows, k) {
  const numbers = rows[Math.min(k, rows.length - 1)];
  return numbers
      ? name + " [" + data.unit + "]: " + numbers.map((p) => p.toFixed(1)).join("  ") + "   " : "";
}
function draw() {
  const k = Math.round(at);
  drawWorld();
  for (const track of data.tracks) drawTrack(track, k);
  slider.value = k;
  document.getElementById("clock").textContent =
      (k / data.rate_hz).toFixed(2) + " s of " + ((frames - 1) / data.rate_hz).toFixed(2);
  document.getElementById("setpoints").textContent =
      row("set points", data.setpoints_kpa, k) + row("pressures", data.pressures_kpa, k);
}
function tick(now) {
  if (playing && before !== null) {
    at += (now - before) / 1000 * data.rate_hz * Number(document.getElementById("speed").value);
    if (at > frames - 1 + data.rate_hz) at = 0;  // a second's rest at the end
    const shown = at;
    at = Math.min(at, frames - 1);
    draw();
    at = shown;
  }
  before = now;
  requestAnimationFrame(tick);
}
document.getElementById("play").onclick = (event) => {
  playing = !playing;
  event.target.textContent = playing ? "pause" : "play";
};
slider.oninput = () => {
  playing = false;
  document.getElementById("play").textContent = "play";
  at = Number(slider.value);
  draw();
};
for (const track of data.tracks) {
  const key = document.createElement("span");
  const swatch = document.createElement("span");
  swatch.className = "key";
  swatch.style.background = track.color;
  key.append(swatch, " " + track.label);
  document.getElementById("legend").append(key);
}
window.onresize = resize;
resize();
requestAnimationFrame(tick);
</script>
</body>
</html>
)html";

}  // namespace limber
