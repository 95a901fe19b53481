import {expect, it} from 'vitest';
import {toCsv} from './csv_file';

it('quotes what a comma, a quote or a line end would break', () => {
  expect(toCsv([['name', 'link'], ['Doe, Jane "JD"', '/join?token=1']]))
    .toBe('name,link\r\n"Doe, Jane ""JD""",/join?token=1\r\n');
});

it('lets no cell run as a formula', () => {
  expect(toCsv([['=1+1', '-x', 'a=b']])).toBe("'=1+1,'-x,a=b\r\n");
});
