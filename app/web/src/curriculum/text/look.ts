// How the text looks, in the words of tokens.css, so that it follows the theme of the page.
import {codeFolding, foldGutter, HighlightStyle, syntaxHighlighting, syntaxTree} from '@codemirror/language';
import {RangeSetBuilder, type Extension} from '@codemirror/state';
import {Decoration, type DecorationSet, EditorView, ViewPlugin, type ViewUpdate} from '@codemirror/view';
import {tags} from '@lezer/highlight';

const theme = EditorView.theme({
  '&': {height: '100%', backgroundColor: 'var(--surface)', color: 'var(--text)', fontSize: '12px'},
  '&.cm-focused': {outline: '2px solid var(--focus)', outlineOffset: '-2px'},
  '.cm-scroller': {fontFamily: 'var(--mono)', lineHeight: '18px', fontVariantNumeric: 'tabular-nums'},
  '.cm-content': {padding: '8px 0 40px', caretColor: 'var(--text)'},
  '.cm-line': {padding: '0 20px 0 4px'},
  '.cm-cursor': {borderLeftColor: 'var(--text)'},
  '.cm-gutters': {backgroundColor: 'var(--surface)', color: 'var(--text-3)', border: 'none', paddingLeft: '6px'},
  '.cm-lineNumbers .cm-gutterElement': {padding: '0 4px 0 6px', minWidth: '32px'},
  '.cm-activeLine': {backgroundColor: 'transparent'},
  '&.cm-focused .cm-activeLine': {boxShadow: 'inset 0 0 0 1px var(--line)'},
  '.cm-activeLineGutter': {backgroundColor: 'transparent', color: 'var(--text)'},
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {backgroundColor: 'var(--accent-soft) !important'},
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': {backgroundColor: 'var(--surface-3)', color: 'inherit'},
  '.cm-foldPlaceholder': {background: 'var(--surface-2)', border: 'none', color: 'var(--text-3)', fontFamily: 'var(--font)', padding: '0 6px', margin: '0 4px'},
  '.cm-foldGutter .cm-gutterElement': {cursor: 'pointer', width: '14px'},
  '.cm-number': {color: 'var(--warn)'},
  '.cm-signs': {width: '18px'},
  '.cm-sign': {display: 'grid', placeItems: 'center', height: '18px'},
  '.cm-sign .icon': {width: '13px', height: '13px'},
  '.cm-error': {color: 'var(--bad)'},
  '.cm-warning': {color: 'var(--warn)'},
  '.cm-squiggle': {color: 'inherit', textDecoration: 'underline wavy', textUnderlineOffset: '3px', textDecorationSkipInk: 'none'},
  '.cm-squiggle.cm-error': {color: 'inherit', textDecorationColor: 'var(--bad)'},
  '.cm-squiggle.cm-warning': {color: 'inherit', textDecorationColor: 'var(--warn)'},
  '.cm-line-error': {backgroundColor: 'var(--bad-soft)'},
  '.cm-line-warning': {backgroundColor: 'var(--warn-soft)'},
  '.cm-sentence': {font: '400 13px/18px var(--font)', padding: '5px 20px 6px 4px', color: 'var(--text)', whiteSpace: 'normal', maxWidth: '110ch'},
  '.cm-sentences:has(.cm-error)': {backgroundColor: 'var(--bad-soft)'},
  '.cm-sentences:not(:has(.cm-error))': {backgroundColor: 'var(--warn-soft)'},
  '.cm-sentence b': {fontWeight: '600'},
  '.cm-sentence.cm-error b': {color: 'var(--bad)'},
  '.cm-sentence.cm-warning b': {color: 'var(--warn)'},
  '.cm-repair': {border: '0', background: 'none', padding: '3px 2px', minHeight: '24px', color: 'var(--accent)', font: '600 13px/18px var(--font)', cursor: 'pointer'},
  '.cm-repair:hover': {textDecoration: 'underline'},
});

const colours = syntaxHighlighting(HighlightStyle.define([
  {tag: [tags.definition(tags.propertyName), tags.propertyName], color: 'var(--accent)'},
  {tag: tags.string, color: 'var(--ok)'},
  {tag: [tags.comment, tags.lineComment], color: 'var(--text-3)'},
  {tag: [tags.punctuation, tags.separator, tags.squareBracket, tags.brace], color: 'var(--text)'},
  {tag: [tags.keyword, tags.typeName, tags.labelName], color: 'var(--bad)'},
]));

const isNumber = /^[-+]?(\d[\d.]*|\.\d+)(e[-+]?\d+)?$/i;
const numberMark = Decoration.mark({class: 'cm-number'});

// the language calls every bare word a literal
const numbers = ViewPlugin.fromClass(class {
  decorations: DecorationSet;

  constructor(view: EditorView) {
    this.decorations = numbersOf(view);
  }

  update(update: ViewUpdate): void {
    const parsed = syntaxTree(update.state) !== syntaxTree(update.startState);
    if (update.docChanged || update.viewportChanged || parsed) this.decorations = numbersOf(update.view);
  }
}, {decorations: (plugin) => plugin.decorations});

function numbersOf(view: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const {from, to} of view.visibleRanges) {
    syntaxTree(view.state).iterate({from, to, enter: (node) => {
      if (node.name === 'Literal' && node.node.parent?.name !== 'Key' && isNumber.test(view.state.sliceDoc(node.from, node.to))) {
        builder.add(node.from, node.to, numberMark);
      }
    }});
  }
  return builder.finish();
}

const folding = codeFolding({
  preparePlaceholder: (state, range) => state.doc.lineAt(range.to).number - state.doc.lineAt(range.from).number,
  placeholderDOM: (_view, onclick, lines: number) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'cm-foldPlaceholder';
    button.textContent = `${lines} ${lines === 1 ? 'line' : 'lines'} folded`;
    button.onclick = onclick;
    return button;
  },
});

export const look: Extension = [theme, colours, numbers, folding, foldGutter({openText: '▾', closedText: '▸'})];
