import {expect, it} from 'vitest';
import {suggestedName} from './sign_in_name';

it('makes a name that every keyboard can type', () => {
  expect(suggestedName('Resident 14')).toBe('resident.14');
  expect(suggestedName('José Ærø-Straße')).toBe('jose.aero.strasse');
  expect(suggestedName("Ana O'Neill")).toBe('ana.oneill');
  expect(suggestedName('研修医')).toBe('');
});
