package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.wording.Measure;
import org.maestro.ontology.wording.Said;
import org.maestro.ontology.wording.StateWord;
import org.maestro.ontology.wording.Wording;
import org.maestro.sl.Term;

/** Gathers the lexicon of a home: its labels and other names are its vocabulary. */
public final class LexiconOfHome {
  private static final String PLURAL = "plural";

  private final Home home;
  private final Wording wording;
  private final Grammar grammar;
  private final Tokens tokens;
  private final Map<List<String>, Map<String, List<Form>>> entries = new HashMap<>();

  public LexiconOfHome(Home home, Grammar grammar) {
    this.home = home;
    this.wording = home.wording();
    this.grammar = grammar;
    this.tokens = new Tokens(grammar.spellings());
  }

  /** The lexicon. */
  public Lexicon read() {
    names();
    home.vocabulary()
        .classes()
        .keySet()
        .forEach(
            name -> {
              Form noun = Form.of("noun", leaf(name));
              enter(Lexicon.NOUN, name, noun);
              for (List<String> words : named(name)) {
                enter(Lexicon.NOUNS, plural(words), noun);
              }
            });
    home.scripts()
        .keySet()
        .forEach(name -> enter(Lexicon.SCRIPT, name, Form.of("script", leaf(name))));
    adjectives();
    grouped(Lexicon.PREPOSITION, "prep", wording.prepositions());
    Map<String, List<Said>> fluents = new LinkedHashMap<>();
    wording.measures().keySet().forEach(name -> fluents.put(name, said(name)));
    grouped(Lexicon.FLUENT, "fluent", fluents);
    grouped(Lexicon.MORE, "more", measures(Measure::more));
    grouped(Lexicon.LESS, "less", measures(Measure::less));
    grouped(Lexicon.HOW_MUCH, "howMuch", measures(Measure::asked));
    Map<String, List<Said>> states = new LinkedHashMap<>();
    for (StateWord state : wording.states()) {
      states.put(state.name(), state.says());
    }
    grouped(Lexicon.STATE, "state", states);
    Set<String> classes = new HashSet<>();
    home.individuals().values().forEach(one -> classes.addAll(one.classes()));
    return new Lexicon(
        entries, grammar, form -> !form.is("noun") || classes.contains(form.text(0)));
  }

  /** Things that are called the same are one entry: which of them is meant shows later. */
  private void names() {
    Map<List<String>, List<Form>> byWords = new LinkedHashMap<>();
    for (String name : home.individuals().keySet()) {
      for (List<String> words : named(name)) {
        byWords.computeIfAbsent(words, w -> new ArrayList<>()).add(leaf(name));
      }
    }
    byWords.forEach((words, same) -> enter(Lexicon.NAME, words, new Form("name", same)));
  }

  private Map<String, List<Said>> measures(Function<Measure, List<Said>> words) {
    Map<String, List<Said>> found = new LinkedHashMap<>();
    wording.measures().forEach((name, measure) -> found.put(name, words.apply(measure)));
    return found;
  }

  private static Form leaf(String text) {
    return Form.leaf(text);
  }

  private List<Said> said(String name) {
    return wording.names().getOrDefault(name, List.of());
  }

  private void enter(String category, String name, Form form) {
    for (List<String> words : named(name)) {
      enter(category, words, form);
    }
  }

  private void enter(String category, List<String> words, Form form) {
    List<Form> forms =
        entries
            .computeIfAbsent(words, w -> new LinkedHashMap<>())
            .computeIfAbsent(category, c -> new ArrayList<>());
    if (!forms.contains(form)) {
      forms.add(form);
    }
  }

  /** What it is called, with and without its article, and without its 's. */
  private Set<List<String>> named(String name) {
    Set<List<String>> all = new LinkedHashSet<>();
    for (Said said : said(name)) {
      if (said.isIn(grammar.language())) {
        List<String> words = tokens.of(said.text());
        if (words.isEmpty()) {
          continue;
        }
        List<String> bare = withoutArticle(words);
        all.add(words);
        all.add(bare);
        List<String> compound = bare.stream().filter(word -> !word.equals("'s")).toList();
        if (compound.size() < bare.size()) {
          all.add(compound);
        }
      }
    }
    return all;
  }

  private List<String> withoutArticle(List<String> words) {
    return words.size() > 1 && grammar.list("article").contains(List.of(words.get(0)))
        ? List.copyOf(words.subList(1, words.size()))
        : words;
  }

  private List<String> plural(List<String> words) {
    List<String> several = new ArrayList<>(words);
    int last = words.size() - 1;
    several.set(last, grammar.inflection().of(words.get(last), PLURAL));
    return List.copyOf(several);
  }

  private void adjectives() {
    for (Individual individual : home.individuals().values()) {
      for (String predicate : wording.describing()) {
        for (Term value : individual.properties().getOrDefault(predicate, List.of())) {
          if (value instanceof Term.Text text) {
            enter(
                Lexicon.ADJECTIVE,
                tokens.of(text.value()),
                Form.of("adj", leaf(predicate), leaf(text.value()), leaf("text")));
          } else if (value instanceof Term.Name name) {
            enter(
                Lexicon.ADJECTIVE,
                name.text(),
                Form.of("adj", leaf(predicate), leaf(name.text()), leaf("name")));
          }
        }
      }
    }
  }

  /** Words that several names share are one entry, which names them all. */
  private void grouped(String category, String head, Map<String, List<Said>> names) {
    Map<List<String>, List<Form>> byWords = new LinkedHashMap<>();
    names.forEach(
        (name, said) -> {
          for (Said one : said) {
            if (one.isIn(grammar.language())) {
              List<String> words = tokens.of(one.text());
              List<Form> same = byWords.computeIfAbsent(words, w -> new ArrayList<>());
              if (!words.isEmpty() && !same.contains(leaf(name))) {
                // What is called so first of all is meant first.
                same.add(one.equals(said.get(0)) ? 0 : same.size(), leaf(name));
              }
            }
          }
        });
    byWords.forEach(
        (words, same) -> {
          if (!words.isEmpty()) {
            enter(category, words, new Form(head, same));
          }
        });
  }
}
