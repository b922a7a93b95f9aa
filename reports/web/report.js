// Adds to a page that is complete without it: sorting of tables, zooming and hovering in charts, downloads.
(function () {
  "use strict";

  const element = (name, properties) => Object.assign(document.createElement(name), properties);

  function saveBlob(blob, name) {
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  // --- CSV: text that a spreadsheet would take for a formula gets an apostrophe in front.
  function csvCell(value) {
    if (value === null || value === undefined) return "";
    if (typeof value === "number") return String(value);
    const text = /^'*[=+\-@\t\r\n]/.test(value) ? "'" + value : String(value);
    return /[",\r\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
  }
  const csvOf = (rows) => rows.map((row) => row.map(csvCell).join(",") + "\n").join("");

  function rowsOf(data) {
    if (!data.series) return [data.columns, ...data.rows];
    const rows = [["series", data.x.label, data.y.label]];
    for (const series of data.series) series.x.forEach((x, k) => rows.push([series.name, x, series.y[k]]));
    return rows;
  }

  // --- Pictures: all SVGs of a figure side by side in one, colours as they are on the page.
  function pictureOf(figure) {
    const parts = [...figure.querySelectorAll("svg.plot")].map((svg) => ({
      copy: svg.cloneNode(true), width: svg.viewBox.baseVal.width, height: svg.viewBox.baseVal.height }));
    const all = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    let x = 0, y = 0, rowHeight = 0, widest = 0;
    const rowLimit = Math.max(1200, ...parts.map((part) => part.width));
    for (const part of parts) {
      if (x > 0 && x + part.width > rowLimit) { x = 0; y += rowHeight + 10; rowHeight = 0; }
      for (const [name, value] of [["x", x], ["y", y], ["width", part.width], ["height", part.height]])
        part.copy.setAttribute(name, value);
      all.append(part.copy);
      x += part.width + 10;
      widest = Math.max(widest, x);
      rowHeight = Math.max(rowHeight, part.height);
    }
    const style = getComputedStyle(figure);
    const height = y + rowHeight;
    const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    for (const [name, value] of [["width", "100%"], ["height", "100%"], ["fill", style.backgroundColor]])
      ground.setAttribute(name, value);
    all.prepend(ground);
    all.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    all.setAttribute("viewBox", `0 0 ${widest} ${height}`);
    all.setAttribute("width", widest);
    all.setAttribute("height", height);
    all.setAttribute("color", style.color);
    return { text: new XMLSerializer().serializeToString(all), width: widest, height };
  }

  function savePng(figure) {
    const picture = pictureOf(figure), scale = 2, image = new Image();
    const address = URL.createObjectURL(new Blob([picture.text], { type: "image/svg+xml" }));
    image.onload = () => {
      const canvas = element("canvas", { width: picture.width * scale, height: picture.height * scale });
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => saveBlob(blob, figure.id + ".png"), "image/png");
      URL.revokeObjectURL(address);
    };
    image.src = address;
  }

  // --- Zooming and hovering by uPlot.
  const shown = (value) => (value === null || value === undefined ? "" : String(Number(value.toPrecision(5))));
  const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  const powerOfTen = (value) => "10" + String(Math.round(Math.log10(value))).replace("-", "⁻").replace(/\d/g, (digit) => superscripts[digit]);
  const isPower = (value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9;

  // Over several decades only these are marked, and not more than fit.
  function logarithmicTicks(_, ticks) {
    if (Math.log10(ticks[ticks.length - 1] / ticks[0]) < 2) return ticks;
    const stride = 1 + Math.floor(Math.log10(ticks[ticks.length - 1] / ticks[0]) / 8);
    return ticks.map((value) => (isPower(value) && Math.round(Math.log10(value)) % stride === 0 ? value : null));
  }
  function tickText(value, logarithmic) {
    if (value === null) return "";
    return logarithmic && isPower(value) && (value < 0.01 || value > 1000) ? powerOfTen(value) : shown(value);
  }

  function tableOf(series, data) {
    const usable = (value, axis) => value !== null && (!axis.log || value > 0);
    const points = series.x.map((x, k) => [x, series.y[k]]).filter(([x, y]) => usable(x, data.x) && usable(y, data.y));
    points.sort((a, b) => a[0] - b[0]);
    const once = points.filter(([x], k) => k === 0 || x !== points[k - 1][0]);
    return [once.map((point) => point[0]), once.map((point) => point[1])];
  }

  // Named stretches of the x axis, every second one shaded as in the picture.
  function shadeSpans(plot, spans, ink) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.globalAlpha = 0.09;
    ctx.fillStyle = ink;
    spans.forEach(([begin, end], k) => {
      const left = plot.valToPos(begin, "x", true), right = plot.valToPos(end, "x", true);
      if (k % 2 === 0) ctx.fillRect(left, bbox.top, right - left, bbox.height);
    });
    ctx.restore();
  }

  function makeLive(figure, data, width) {
    const ink = getComputedStyle(figure).color;
    const faint = ink.replace("rgb(", "rgba(").replace(")", ", 0.15)");
    const axis = (one, size) => {
      const filter = one.log ? logarithmicTicks : (_, ticks) => ticks;
      return { label: one.label, stroke: ink, size, filter, grid: { stroke: faint, width: 1, filter }, ticks: { stroke: faint, filter },
        values: (_, ticks) => ticks.map((value) => tickText(value, one.log)) };
    };
    const options = {
      width, height: Math.max(280, Math.round(width * 0.6)),
      scales: { x: { time: false, distr: data.x.log ? 3 : 1 }, y: { distr: data.y.log ? 3 : 1 } },
      axes: [axis(data.x, 46), axis(data.y, 66)],
      hooks: { drawClear: [(plot) => shadeSpans(plot, data.spans || [], ink)] },
      cursor: { drag: { x: true, y: true, uni: 20 } },
      series: [{ label: data.x.label, value: (_, value) => shown(value) }].concat(data.series.map((series) => ({
        label: series.name,
        stroke: series.colour === "currentColor" ? ink : series.colour,
        width: series.kind === "line" ? 1.8 : 0,
        dash: series.dash ? series.dash.split(" ").map(Number) : undefined,
        points: { show: series.kind !== "line" || series.x.length < 40, size: 7 },
        spanGaps: true,
        value: (_, value) => shown(value),
      }))),
    };
    const holder = element("div", { className: "interactive" });
    figure.querySelector("svg.plot").after(holder);
    holder.append(element("p", { className: "live-hint", textContent: "Drag to zoom, double-click to see all again; click a name to hide it." }));
    return new uPlot(options, uPlot.join(data.series.map((series) => tableOf(series, data))), holder);
  }

  function toggleLive(figure, data, button) {
    const live = figure.classList.toggle("live");
    button.textContent = live ? "Static picture" : "Zoom and hover";
    if (live) makeLive(figure, data, figure.querySelector("figcaption").clientWidth);
    else figure.querySelector(".interactive").remove();
  }

  function addTools(figure) {
    const script = figure.querySelector("script[type='application/json']");
    const data = script ? JSON.parse(script.textContent) : null;
    const tools = element("div", { className: "tools" });
    const add = (text, action, className) => {
      const button = element("button", { type: "button", textContent: text, className: className || "" });
      button.addEventListener("click", () => action(button));
      tools.append(button);
    };
    if (data && data.series && typeof uPlot === "function")
      add("Zoom and hover", (button) => toggleLive(figure, data, button), "main");
    add("SVG", () => saveBlob(new Blob([pictureOf(figure).text], { type: "image/svg+xml" }), figure.id + ".svg"));
    add("PNG", () => savePng(figure));
    if (data) add("CSV", () => saveBlob(new Blob([csvOf(rowsOf(data))], { type: "text/csv" }), figure.id + ".csv"));
    figure.append(tools);
  }

  // --- Tables.
  function keyOf(cell) {
    const text = cell.dataset.v === undefined ? cell.textContent : cell.dataset.v;
    const number = Number(text);
    return text.trim() !== "" && !Number.isNaN(number) ? number : text;
  }

  // Numbers before text, empty cells last in both directions.
  function compare(a, b, direction) {
    if ((a === "") !== (b === "")) return a === "" ? 1 : -1;
    if (typeof a === "number" && typeof b === "number") return direction * (a - b);
    if (typeof a !== typeof b) return direction * (typeof a === "number" ? -1 : 1);
    return direction * a.localeCompare(b);
  }

  function sortBy(table, heading, column) {
    const direction = heading.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    const rows = [...table.tBodies[0].rows];
    rows.sort((a, b) => compare(keyOf(a.cells[column]), keyOf(b.cells[column]), direction));
    table.tBodies[0].append(...rows);
  }

  function makeSortable(table) {
    [...table.tHead.rows[0].cells].forEach((heading, column) => {
      const button = element("button", { type: "button", textContent: heading.textContent });
      heading.replaceChildren(button);
      button.addEventListener("click", () => sortBy(table, heading, column));
    });
  }

  document.querySelectorAll("table.sortable").forEach(makeSortable);
  document.querySelectorAll("figure").forEach(addTools);
})();
