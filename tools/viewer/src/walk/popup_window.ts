// The building's information window, as the product's snapshots show it.

import { element, name, replace, Scope } from '../ui/dom';
import { isDuring } from '../data/spans';
import type { WalkContext } from './context';

export function popupWindow(context: WalkContext, scope: Scope): HTMLElement {
  const root = element('aside', { class: 'popup', attributes: { 'aria-live': 'polite', 'aria-label': 'Pop-up' } });
  const popups = context.data.details.recording?.popups ?? [];
  context.store.on(
    scope,
    (state) => popups.findLastIndex((popup) => isDuring(popup, Math.floor(state.tick))),
    (index) => {
      const popup = popups[index];
      root.hidden = popup === undefined;
      if (!popup) return;
      const building = context.campus?.buildings.find((each) => each.id === popup.building);
      const fields: [string, string][] = [
        ...(building?.hours ? [['Hours', building.hours] as [string, string]] : []),
        ...(building?.floors ? [['Floors', String(building.floors)] as [string, string]] : []),
        ...(building?.info ?? []).map((field): [string, string] => [field.name, field.value]),
      ];
      replace(
        root,
        element('h2', {}, name(popup.title)),
        element('p', { class: 'popup-id', text: popup.building }),
        popup.text !== '' && element('p', { class: 'popup-text', text: popup.text, attributes: { dir: 'auto' } }),
        fields.length > 0 &&
          element(
            'dl',
            {},
            ...fields.flatMap(([key, value]) => [element('dt', { text: key }), element('dd', {}, name(value))]),
          ),
      );
    },
  );
  return root;
}
