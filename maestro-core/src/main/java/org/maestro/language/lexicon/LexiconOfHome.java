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
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.wording.Measure;
import org.maestro.ontology.wording.Said;
import org.maestro.ontology.wording.StateWord;
import org.maestro.ontology.wording.Wording;
import org.maestro.sl.Term;

/** Gathers the lexicon of a home: its labels and other names are its vocabulary. */
public final class LexiconOfHome {
  private static final String PLURAL = "plural";
  private static final String THING = "Thing";
  private static final String ROOM = "Zone";
  private static final String POSITIVE = "positive";
  private static final String SUPERLATIVE = "superlative";
  private static final String ADJECTIVE_FORMS = "adjective-forms";

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
    nouns();
    home.scripts()
        .keySet()
        .forEach(name -> enter(Lexicon.SCRIPT, name, Form.of("script", leaf(name))));
    adjectives();
    grouped(Lexicon.PREPOSITION, "prep", wording.prepositions());
    Map<String, List<Said>> fluents = new LinkedHashMap<>();
    wording.measures().keySet().forEach(name -> fluents.put(name, said(name)));
    grouped(Lexicon.FLUENT, "fluent", fluents);
    wording
        .describing()
        .forEach(name -> enter(Lexicon.ATTRIBUTE, name, Form.of("attribute", leaf(name))));
    grouped(Lexicon.MORE, "more", measures(Measure::more));
    grouped(Lexicon.LESS, "less", measures(Measure::less));
    grouped(Lexicon.HIGH, "more", measures(measure -> positive(measure.more())));
    grouped(Lexicon.LOW, "less", measures(measure -> positive(measure.less())));
    grouped(Lexicon.MOST, "more", measures(measure -> superlative(measure.more())));
    grouped(Lexicon.LEAST, "less", measures(measure -> superlative(measure.less())));
    grouped(Lexicon.HOW_MUCH, "howMuch", measures(Measure::asked));
    Map<String, List<Said>> states = new LinkedHashMap<>();
    for (StateWord state : wording.states()) {
      states.put(state.name(), state.says());
    }
    grouped(Lexicon.STATE, "state", states);
    statesOfNouns();
    Map<String, List<Said>> forms = new LinkedHashMap<>();
    states.forEach((name, said) -> forms.put(name, said.stream().flatMap(this::formsOf).toList()));
    grouped(Lexicon.STATE_FORM, "state", forms);
    Set<String> classes = new HashSet<>();
    home.individuals().values().forEach(one -> classes.addAll(one.classes()));
    return new Lexicon(
        entries, grammar, form -> !form.is("noun") || classes.contains(form.text(0)));
  }

  /** Things that are called the same are one entry: which of them is meant shows later. */
  private void names() {
    Map<List<String>, List<Form>> byWords = new LinkedHashMap<>();
    for (String name : home.individuals().keySet()) {
      for (List<String> words : named(called(name))) {
        byWords.computeIfAbsent(words, w -> new ArrayList<>()).add(leaf(name));
      }
    }
    byWords.forEach(
        (words, same) -> {
          Form named = new Form("name", same);
          enter(Lexicon.NAME, words, named);
          if (same.stream().allMatch(name -> isSpokenTo(name.head()))) {
            enter(Lexicon.ADDRESSEE, words, named);
          }
          List<Form> rooms = same.stream().filter(name -> isRoom(name.head())).toList();
          if (!rooms.isEmpty()) {
            enter(Lexicon.ROOM, words, new Form("name", rooms));
          }
          forms("name-forms")
              .forEach(form -> enter(Lexicon.NAME_OWNING, inflected(words, form), named));
        });
  }

  private boolean isRoom(String name) {
    Individual individual = home.individuals().get(name);
    return individual != null && individual.classes().contains(ROOM);
  }

  /**
   * Only what acts by itself, as a robot does: who is spoken to is passed over, and where the room
   * is that a sentence speaks to, or ends with, tells what is meant.
   */
  private boolean isSpokenTo(String name) {
    Individual individual = home.individuals().get(name);
    return home.devices().containsKey(name)
        && individual != null
        && individual.classes().contains(THING);
  }

  private List<String> forms(String list) {
    return grammar.list(list).stream().map(words -> words.get(0)).toList();
  }

  /** The words, and their other forms. */
  private List<List<String>> withForms(String list, List<String> words) {
    List<List<String>> all = new ArrayList<>(List.of(words));
    forms(list).forEach(form -> all.add(inflected(words, form)));
    return all;
  }

  private Stream<Said> formsOf(Said said) {
    List<String> words = tokens.of(said.text());
    return words.isEmpty()
        ? Stream.of()
        : forms(ADJECTIVE_FORMS).stream()
            .map(form -> new Said(String.join(" ", inflected(words, form)), said.language()));
  }

  /** Of classes that are called the same the wider one is meant: what else is said narrows it. */
  private void nouns() {
    Map<List<String>, Set<String>> classes = new LinkedHashMap<>();
    for (String name : home.vocabulary().classes().keySet()) {
      for (List<String> words : named(name)) {
        classes.computeIfAbsent(words, w -> new LinkedHashSet<>()).add(name);
      }
    }
    classes.forEach(
        (words, same) ->
            same.stream()
                .filter(name -> same.stream().noneMatch(wider -> isNarrower(name, wider)))
                .forEach(
                    name -> {
                      Form noun = Form.of("noun", leaf(name));
                      withForms("noun-forms", words).forEach(one -> enter(Lexicon.NOUN, one, noun));
                      withForms("plural-forms", inflected(words, PLURAL))
                          .forEach(several -> enter(Lexicon.NOUNS, several, noun));
                    }));
  }

  private boolean isNarrower(String name, String other) {
    ClassDeclaration declared = home.vocabulary().classes().get(name);
    return !name.equals(other) && declared != null && declared.ancestors().contains(other);
  }

  /** The kitchen light is a thing, and nobody says by it that the kitchen is to become light. */
  private void statesOfNouns() {
    entries
        .values()
        .forEach(
            categories -> {
              List<Form> states = categories.get(Lexicon.STATE);
              if (states != null && categories.containsKey(Lexicon.NOUN)) {
                categories.put(Lexicon.NOUN_STATE, states);
                categories.remove(Lexicon.STATE);
              }
            });
  }

  private Map<String, List<Said>> measures(Function<Measure, List<Said>> words) {
    Map<String, List<Said>> found = new LinkedHashMap<>();
    wording.measures().forEach((name, measure) -> found.put(name, words.apply(measure)));
    return found;
  }

  /** What is brighter is bright. */
  private List<Said> positive(List<Said> comparatives) {
    return inForm(POSITIVE, comparatives);
  }

  /** What is brighter than all others is the brightest. */
  private List<Said> superlative(List<Said> comparatives) {
    return inForm(SUPERLATIVE, comparatives).stream()
        .flatMap(said -> Stream.concat(Stream.of(said), formsOf(said)))
        .toList();
  }

  private List<Said> inForm(String form, List<Said> comparatives) {
    List<Said> all = new ArrayList<>();
    for (Said comparative : comparatives) {
      String said = grammar.inflection().of(comparative.text(), form);
      if (comparative.isIn(grammar.language()) && !said.equals(comparative.text())) {
        all.add(comparative.saying(said));
      }
    }
    return all;
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

  /** What it is called, with and without its article, and without what tells whose it is. */
  private Set<List<String>> named(String name) {
    return named(inLanguage(said(name)));
  }

  private List<Said> inLanguage(List<Said> all) {
    return all.stream().filter(said -> said.isIn(grammar.language())).toList();
  }

  /** What a thing is called; as elsewhere, where it has no name in the language. */
  private List<Said> called(String thing) {
    List<Said> own = inLanguage(said(thing));
    return own.isEmpty() ? said(thing).stream().limit(1).toList() : own;
  }

  private Set<List<String>> named(List<Said> called) {
    Set<List<String>> all = new LinkedHashSet<>();
    for (Said said : called) {
      List<String> words = tokens.of(said.text());
      if (!words.isEmpty()) {
        List<String> bare = withoutArticle(words);
        all.add(words);
        all.add(bare);
        List<String> compound =
            bare.stream().filter(word -> !grammar.list("owning").contains(List.of(word))).toList();
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

  /** The last word takes the form. */
  private List<String> inflected(List<String> words, String form) {
    List<String> others = new ArrayList<>(words);
    int last = words.size() - 1;
    others.set(last, grammar.inflection().of(words.get(last), form));
    return List.copyOf(others);
  }

  private void adjectives() {
    for (Individual individual : home.individuals().values()) {
      for (String predicate : wording.describing()) {
        for (Term value : individual.properties().getOrDefault(predicate, List.of())) {
          if (value instanceof Term.Text text) {
            adjective(
                tokens.of(text.value()),
                Form.of("adj", leaf(predicate), leaf(text.value()), leaf("text")));
          } else if (value instanceof Term.Name name) {
            Form meant = Form.of("adj", leaf(predicate), leaf(name.text()), leaf("name"));
            named(name.text()).forEach(words -> adjective(words, meant));
          }
        }
      }
    }
  }

  private void adjective(List<String> words, Form form) {
    if (!words.isEmpty()) {
      withForms(ADJECTIVE_FORMS, words).forEach(one -> enter(Lexicon.ADJECTIVE, one, form));
    }
  }

  /** Words that several names share are one entry, which names them all. */
  private void grouped(String category, String head, Map<String, List<Said>> names) {
    Map<List<String>, List<Form>> byWords = new LinkedHashMap<>();
    names.forEach(
        (name, said) -> {
          List<Said> own = inLanguage(said);
          for (Said one : own) {
            List<String> words = tokens.of(one.text());
            List<Form> same = byWords.computeIfAbsent(words, w -> new ArrayList<>());
            if (!words.isEmpty() && !same.contains(leaf(name))) {
              // What is called so first of all is meant first.
              same.add(one.equals(own.get(0)) ? 0 : same.size(), leaf(name));
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
