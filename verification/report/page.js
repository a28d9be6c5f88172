document.documentElement.classList.add("js");
(() => {
  const rows = [...document.querySelectorAll("#claims tbody tr")];
  const search = document.querySelector("#claims input[type=search]");
  const buttons = [...document.querySelectorAll("#claims [data-verdict]")];
  const count = document.querySelector("#claims output");
  const filter = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const wanted = buttons.filter(b => b.getAttribute("aria-pressed") === "true").map(b => b.dataset.verdict);
    let shown = 0;
    for (const row of rows) {
      const verdict = !wanted.length || wanted.some(v => row.classList.contains(v));
      row.hidden = !(verdict && words.every(w => row.dataset.words.includes(w)));
      shown += !row.hidden;
    }
    count.textContent = shown === rows.length ? "" : `${shown} of ${rows.length}`;
  };
  search.addEventListener("input", filter);
  for (const button of buttons) button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
    filter();
  });
  document.addEventListener("keydown", event => {
    if (event.key === "/" && document.activeElement !== search) { event.preventDefault(); search.focus(); }
    if (event.key === "Escape" && document.activeElement === search) { search.value = ""; filter(); search.blur(); }
  });
  for (const button of document.querySelectorAll(".copy")) button.addEventListener("click", async () => {
    await navigator.clipboard.writeText(button.previousElementSibling.textContent);
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  });
})();
