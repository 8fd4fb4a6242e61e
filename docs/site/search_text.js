// The search of the site in place of Doxygen's, in the same field: first names, of Doxygen's lists, then sections of pages
// that have all words, of search/text.js, each with its heading and a line around the first of the words. What search.py
// made is fetched when the field is entered, by elements <script>, which work without a server too.
$(() => {
    if (typeof searchBox === 'undefined') return;
    const SHOWN = { names: 6, sections: 12 };
    const BEFORE = 50, AROUND = 170; // letters of the line
    const results = document.getElementById('MSearchResultsWindow');
    const field = () => document.getElementById('MSearchField');

    const fetched = {};
    const fetchScript = file => fetched[file] ??= new Promise((done, failed) => {
        const script = document.createElement('script');
        script.onload = () => done(window.searchData); // of one of Doxygen's lists, before the next one overwrites it
        script.onerror = () => { delete fetched[file]; failed(); }; // to be tried again
        script.src = file;
        document.head.append(script);
    });
    let index = null;
    const fetchText = async () => {
        await Promise.all([fetchScript('lunr.min.js'), fetchScript('search/text.js')]);
        index ??= lunr.Index.load(searchText.index);
    };

    const make = (tag, name, ...content) => {
        const element = document.createElement(tag);
        if (name) element.className = name;
        element.append(...content);
        return element;
    };
    const link = (address, ...content) => {
        const element = make('a', '', ...content);
        element.href = address;
        element.onclick = () => searchBox.CloseResultsWindow();
        return element;
    };
    const plain = markup => new DOMParser().parseFromString(markup, 'text/html').body.textContent;

    // Names that begin with what is typed: [name, [[address, scope], ...]].
    async function names(typed) {
        const letter = indexSectionsWithContent[searchBox.searchIndex].indexOf(typed[0].toLowerCase());
        if (letter < 0) return [];
        const list = await fetchScript(`search/${indexSectionNames[searchBox.searchIndex]}_${letter.toString(16)}.js`);
        const begin = convertToId(typed.toLowerCase());
        return list.filter(([id]) => id.toLowerCase().startsWith(begin)).map(([, [name, ...places]]) =>
            [plain(name), places.map(([address, , scope]) => [address.replace(/^\.\.\//, ''), plain(scope ?? '')])]);
    }

    // Is it a word that search.py puts into the index?
    const inIndex = word => word.length > 1 && /\p{L}/u.test(word) && lunr.stopWordFilter(new lunr.Token(word));

    // What is typed as words, and how words begin that are taken for the same.
    function beginnings(typed) {
        const words = typed.toLowerCase().match(/[\p{L}\p{N}_]+/gu) ?? [];
        return words.filter(inIndex).map(word => {
            const stem = lunr.stemmer(new lunr.Token(word)).toString();
            return stem.length > 3 && stem !== word ? [word, stem] : [word];
        });
    }

    // Numbers of the sections that have all words, the best first.
    function sections(words, typed) {
        let scores = null;
        for (const [word, stem] of words) {
            const found = index.query(query => {
                query.term(word, { boost: 4 });
                for (const begin of [word, stem ?? ''].filter(it => it.length > 1))
                    query.term(begin, { wildcard: lunr.Query.wildcard.TRAILING });
            });
            const before = scores;
            scores = new Map(found.filter(({ ref }) => before?.has(ref) ?? true)
                .map(({ ref, score }) => [ref, score + (before?.get(ref) ?? 0)]));
        }
        const phrase = typed.toLowerCase();
        const score = ([ref, sum]) => {
            const [, , heading, text] = searchText.sections[ref];
            return words.length > 1 && `${heading}\n${text}`.toLowerCase().includes(phrase) ? 2 * sum : sum;
        };
        return [...scores ?? []].map(it => [it[0], score(it)]).sort((a, b) => b[1] - a[1]).map(([ref]) => ref);
    }

    // A text with the words marked.
    function marked(text, pattern) {
        const parts = text.split(pattern); // every second is a word
        return parts.map((part, k) => k % 2 ? make('mark', '', part) : part);
    }

    function line(text, pattern) {
        const from = text.search(pattern);
        let begin = from < BEFORE ? 0 : text.indexOf(' ', from - BEFORE) + 1;
        if (begin > from) begin = Math.max(from, 0);
        const end = begin + AROUND < text.length ? Math.max(text.lastIndexOf(' ', begin + AROUND), from) : text.length;
        return [begin ? '… ' : '', ...marked(text.slice(begin, end), pattern), end < text.length ? ' …' : ''];
    }

    function section(number, pattern) {
        const [page, anchor, heading, text] = searchText.sections[number];
        const [file, title] = searchText.pages[page];
        const element = link(file + (anchor && '#' + anchor), make('b', '', ...marked(heading || title, pattern)));
        if (heading) element.append(make('span', 'page', title));
        element.append(make('span', 'line', ...line(text, pattern)));
        return element;
    }

    function name([text, places]) {
        if (places.length === 1) return link(places[0][0], make('b', '', text), make('span', 'page', places[0][1]));
        return make('details', '', make('summary', '', make('b', '', text), make('span', 'page', `${places.length} places`)),
            ...places.map(([address, scope]) => link(address, scope)));
    }

    // A heading, the first of the results, and a button that shows the others.
    function list(heading, found, shown, show) {
        if (!found.length) return [];
        const more = make('button', '', `All ${found.length}`);
        more.type = 'button';
        more.onclick = () => {
            const others = found.slice(shown).map(show);
            more.replaceWith(...others);
            (others[0].querySelector('summary') ?? others[0]).focus();
        };
        return [make('h2', '', heading), ...found.slice(0, shown).map(show), ...found.length > shown ? [more] : []];
    }

    searchBox.keyTimeoutLength = 150;
    searchBox.Search = async () => {
        const typed = field().value.trim();
        if (!typed) return;
        searchBox.keyTimeout = 0;
        searchBox.lastSearchValue = field().value.replace(/ +/g, '');
        const withText = ['all', 'pages'].includes(indexSectionNames[searchBox.searchIndex]);
        const [found] = await Promise.all([names(typed).catch(() => []), withText && fetchText().catch(() => {})]);
        if (typed !== field().value.trim()) return; // something else has been typed meanwhile
        const words = withText && index ? beginnings(typed) : [];
        const begin = words.flat().join('|');
        const pattern = new RegExp(`(?<![\\p{L}\\p{N}_])((?:${begin})[\\p{L}\\p{N}_]*)`, 'giu');
        const named = new Set(found.flatMap(([, places]) => places.map(([address]) => address)));
        const inText = (words.length ? sections(words, typed) : []).filter(number => {
            const [page, anchor] = searchText.sections[number];
            return !named.has(searchText.pages[page][0] + (anchor && '#' + anchor));
        });
        results.replaceChildren(...list('Names', found, SHOWN.names, name),
            ...list('Pages', inText, SHOWN.sections, number => section(number, pattern)));
        if (!results.childElementCount) results.append(make('p', '', 'Nothing found'));
        const { bottom } = document.getElementById('MSearchBox').getBoundingClientRect();
        results.style.setProperty('--found-top', `${Math.round(bottom) + 6}px`);
        results.style.display = 'block';
        results.scrollTop = 0;
        searchBox.DOMSearchClose().style.display = 'inline-block';
    };

    // Keys: down and up through the results, Enter to the first, Escape out of them.
    const change = searchBox.OnSearchFieldChange;
    const reachable = () => [...results.querySelectorAll('a, button, summary')].filter(it => it.offsetParent);
    searchBox.OnSearchFieldChange = event => {
        if (['ArrowDown', 'Enter'].includes(event.key) && !event.shiftKey) {
            if (results.style.display === 'block') reachable()[0]?.focus();
        } else {
            change.call(searchBox, event);
        }
    };
    results.addEventListener('keydown', event => {
        const all = reachable(), to = all.indexOf(document.activeElement) + { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (event.key === 'Escape') searchBox.CloseResultsWindow();
        else if (Number.isNaN(to)) return;
        event.preventDefault();
        (event.key === 'Escape' || to < 0 ? field() : all[Math.min(to, all.length - 1)]).focus();
    });
    results.setAttribute('role', 'region');
    results.setAttribute('aria-label', 'What the search found');
    results.replaceChildren();
    $(document).on('focusin', '#MSearchField', () => fetchText().catch(() => {}));
});
