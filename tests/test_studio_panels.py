"""The panels of a model of many patches: only what changed is drawn anew."""

# ruff: noqa: F811, fixtures of another module are named by arguments

from test_studio_browser import DRAW, browser, context, opened, opened_model, pytestmark, served, state  # noqa: F401

# The elements of the panels in which anything was put in, taken out or reworded by a change of the model.
WATCHED = """async (act) => { const { studio } = document.querySelector('[data-quintrig]'), found = [];
    const seen = new MutationObserver((all) => all.forEach(({ target }) =>
      found.push(target.nodeType === 3 ? target.parentElement.className : target.className)));
    for (const one of studio.root.querySelectorAll('.panel, .bar'))
      seen.observe(one, { childList: true, characterData: true, subtree: true });
    const { store } = studio, { model, patch } = store.state, mine = model.patches[patch];
    if (act === 'shape') store.editPatch({ ...mine, shape: [0.5, 0, 0, 0] });
    if (act === 'unit') store.edit({ ...model, unit: 'cm' });
    if (act === 'turn') studio.stage.orbit.turn(20, 5), studio.plan();
    if (act === 'name') store.editPatch({ ...mine, name: 'renamed' });
    for (let i = 0; i < 4; i++) await new Promise(requestAnimationFrame);
    seen.disconnect(); return found; }"""


def test_only_what_changed_is_drawn_anew(context, served):
    page = opened(context, served.site.address)
    tent = [[[i, j, 0.1 * i * (5 - i)] for j in range(6)] for i in range(6)]
    moved = [[[[x, y + 6 * k, z] for x, y, z in row] for row in tent] for k in range(12)]
    patches = [{"kind": "tensor", "name": f"part {k}", "points": points} for k, points in enumerate(moved)]
    opened_model(page, {"patch": patches})
    page.wait_for_timeout(300)
    assert page.evaluate(WATCHED, "turn") == []
    found = page.evaluate(WATCHED, "shape")
    assert state(page, "model.patches[0].shape")[0] == 0.5
    assert "patches" not in found
    assert "patch" not in found
    page.evaluate(DRAW)
    assert "patches" not in page.evaluate(WATCHED, "unit")
    assert "patches" in page.evaluate(WATCHED, "name")
    assert page.locator(".patch span").first.inner_text() == "renamed"


def test_a_claim_is_proved_by_the_server_and_mapped(context, served):
    page = opened(context, served.site.address)
    opened_model(page, {"patch": [{"kind": "torus"}]})
    page.locator("summary", has_text="Proof").click()
    field, said = page.get_by_label("Claim", exact=True), page.locator("details:has(#claims) [role=status]")
    field.fill("gaussian >= 0")
    field.press("Enter")
    said.filter(has_text="refuted at u").wait_for(timeout=20_000)
    mapped = """() => document.querySelector('[data-quintrig]')
      .studio.stage.cells[0].pieces[0].mesh.material.uniforms.proving.value"""
    page.evaluate(DRAW)
    assert page.evaluate(mapped) is True
    field.fill("gausian >= 0")
    field.press("Enter")
    said.filter(has_text="did you mean 'gaussian'").wait_for(timeout=20_000)
    page.evaluate(DRAW)
    assert page.evaluate(mapped) is False
