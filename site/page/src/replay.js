// The page of `tipc view` with a recording, as tip-view makes it (tools/view/src/page.rs); it plays at once.

const ENTITIES = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

export function page(template, title, recording, speaks) {
  const parts = { 'TIP-TITLE': title.replace(/[&<>"']/g, (char) => ENTITIES[char]), 'TIP-RECORDING': recording };
  const filled = template.replace(/TIP-TITLE|TIP-RECORDING/g, (mark) => parts[mark]);
  return filled.replace('<html', `<html data-plays data-speaks="${speaks}"`);
}
