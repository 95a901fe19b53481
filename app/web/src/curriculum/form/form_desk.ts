// What every field of the form works with: the text as a tree, and the way to change it.
import {createContext, useContext} from 'react';
import type {Catalogue} from '../../wire/types';
import type {Change} from '../yaml/edit';
import type {Path, Source, Value} from '../yaml/source';
import {valueIn} from '../yaml/source';
import {type FormMark, isWithin} from './form_marks';

export interface FormDesk {
  readonly source: Source;
  /** The text cannot be read, or may not be changed: the form only shows. */
  readonly frozen: boolean;
  readonly marks: readonly FormMark[];
  readonly catalogue: Catalogue;
  edit(make: (source: Source) => Change[], kind?: 'typing' | 'step'): void;
  /** Brings the place into sight in the text. */
  show(path: Path): void;
  /** Puts the caret there, in the text. */
  goTo(path: Path): void;
  repair(mark: FormMark): void;
}

export const FormContext = createContext<FormDesk | null>(null);

export function useForm(): FormDesk {
  const desk = useContext(FormContext);
  if (!desk) throw new Error('useForm is used outside of the form');
  return desk;
}

export function useValue(path: Path): Value | undefined {
  return valueIn(useForm().source.value, path);
}

export function useList(path: Path): Value[] {
  const value = useValue(path);
  return Array.isArray(value) ? value : [];
}

export function useMarks(path: Path): FormMark[] {
  return useForm().marks.filter((one) => isWithin(one.path, path));
}

export function wordsOf(value: Value | undefined): string[] {
  return Array.isArray(value) ? value.filter((one): one is string => typeof one === 'string') : [];
}

export function pathId(path: Path): string {
  return path.join('.');
}
