(() => {
  const root = document.documentElement;
  const all = (selector, where = document) => [...where.querySelectorAll(selector)];
  root.classList.add("js");

  const theme = document.getElementById("theme");
  const next = { "": "light", light: "dark", dark: "" };
  theme.addEventListener("click", () => {
    const value = next[root.dataset.theme || ""];
    if (value) root.dataset.theme = value; else delete root.dataset.theme;
    theme.textContent = "Theme: " + (value ? value[0].toUpperCase() + value.slice(1) : "Auto");
  });

  for (const code of all(".ask code")) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Copy";
    button.setAttribute("aria-label", "Copy: " + code.textContent);
    button.addEventListener("click", async () => {
      let done = "Copied";
      try { await navigator.clipboard.writeText(code.textContent); }
      catch { getSelection().selectAllChildren(code); done = "Selected"; }
      button.textContent = done;
      setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
    code.after(button);
  }

  let opened = [];
  addEventListener("beforeprint", () => {
    opened = all("details:not([open])");
    for (const part of opened) part.open = true;
  });
  addEventListener("afterprint", () => { for (const part of opened) part.open = false; });

  const search = document.getElementById("q");
  if (!search) return;
  const body = document.querySelector(".claims tbody");
  const none = document.getElementById("none");
  const count = document.getElementById("count");
  const rows = all("tr[data-v]", body);
  const words = new Map(rows.map(row => [row, (row.textContent + row.querySelector("a").hash).toLowerCase()]));
  const wanted = new Set();
  const show = () => {
    const asked = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of rows) {
      const fits = !wanted.size || wanted.has(row.dataset.v);
      row.hidden = !(fits && asked.every(word => words.get(row).includes(word)));
      shown += !row.hidden;
    }
    count.textContent = shown === rows.length ? `${shown} claims` : `${shown} of ${rows.length} claims`;
    none.hidden = shown > 0;
  };
  search.addEventListener("input", show);
  document.addEventListener("keydown", event => {
    const typing = /INPUT|TEXTAREA|SELECT/.test(event.target.tagName);
    if (event.key === "/" && !typing && !event.ctrlKey && !event.metaKey) { event.preventDefault(); search.focus(); }
    if (event.key === "Escape" && document.activeElement === search) { search.value = ""; show(); }
  });
  for (const button of all("[data-f]")) button.addEventListener("click", () => {
    const verdict = button.dataset.f;
    if (!wanted.delete(verdict)) wanted.add(verdict);
    button.setAttribute("aria-pressed", wanted.has(verdict));
    show();
  });

  const order = new Map(rows.map((row, place) => [row, place]));
  const verdicts = ["PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED"];
  const key = (row, name) => {
    if (name === "v") return verdicts.indexOf(row.dataset.v);
    if (name === "c") return row.querySelector("a").hash;
    return row.dataset["s" + name] === undefined ? null : +row.dataset["s" + name];
  };
  for (const button of all(".claims thead button")) button.addEventListener("click", () => {
    const head = button.closest("th");
    const up = head.getAttribute("aria-sort") !== "ascending";
    for (const other of all(".claims thead th")) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    rows.sort((a, b) => {
      const [x, y] = [key(a, button.dataset.k), key(b, button.dataset.k)];
      if (x === y) return order.get(a) - order.get(b);
      if (x === null || y === null) return x === null ? 1 : -1;
      return (x < y ? -1 : 1) * (up ? 1 : -1);
    });
    body.append(...rows, none);
  });
  show();
})();
