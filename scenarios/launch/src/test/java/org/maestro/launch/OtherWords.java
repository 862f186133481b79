package org.maestro.launch;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.lexicon.Tokens;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Measure;
import org.maestro.ontology.wording.Said;
import org.maestro.ontology.wording.StateWord;
import org.maestro.ontology.wording.Wording;

/** Invented words in the place of all words of a home that are not the grammar's own. */
final class OtherWords {
  /** A role in braces, or what stands between blanks, brackets and bars. */
  private static final Pattern PART = Pattern.compile("\\{[^}]*}|[^\\s\\[\\](){}|]+");

  private static final Pattern LETTERS = Pattern.compile("\\p{L}[\\p{L}-]*");
  private static final String CONSONANTS = "bdfgklmnprtv";
  private static final String VOWELS = "aeiou";

  private final Grammar grammar;
  private final Tokens tokens;
  private final Map<String, String> invented = new HashMap<>();

  OtherWords(Home home, Grammar grammar) {
    this.grammar = grammar;
    this.tokens = new Tokens(grammar.spellings());
    Set<String> said = new TreeSet<>(Comparator.comparingInt(String::length).thenComparing(w -> w));
    with(
        home.wording(),
        text -> {
          PART.matcher(text)
              .results()
              .filter(part -> !part.group().startsWith("{"))
              .flatMap(part -> tokens.of(part.group()).stream())
              .filter(word -> LETTERS.matcher(word).matches())
              .forEach(said::add);
          return text;
        });
    Set<String> fixed = fixed(said);
    said.stream().filter(word -> !fixed.contains(word)).forEach(this::invent);
  }

  /** The grammar's own words, and those of the home's that are forms of them, or have them. */
  private Set<String> fixed(Set<String> said) {
    Set<String> fixed = new HashSet<>(HeardWords.wordsOf(grammar));
    grammar.lists().values().forEach(list -> list.forEach(fixed::addAll));
    grammar
        .spellings()
        .forEach(
            (written, meant) -> {
              fixed.add(written);
              fixed.addAll(List.of(meant.split(" ")));
            });
    int before;
    do {
      before = fixed.size();
      for (String word : said) {
        Set<String> forms = forms(word);
        if (fixed.contains(word) || forms.stream().anyMatch(fixed::contains)) {
          fixed.add(word);
          fixed.addAll(forms);
        }
      }
    } while (fixed.size() > before);
    return fixed;
  }

  private Set<String> forms(String word) {
    return grammar.inflection().forms().stream()
        .map(form -> grammar.inflection().of(word, form))
        .collect(Collectors.toSet());
  }

  private void invent(String word) {
    String other = invented.computeIfAbsent(word, w -> next());
    for (String form : grammar.inflection().forms()) {
      invented.putIfAbsent(
          grammar.inflection().of(word, form), grammar.inflection().of(other, form));
    }
  }

  private String next() {
    int left = invented.size();
    StringBuilder word = new StringBuilder();
    for (int syllable = 0; syllable < 3; syllable++) {
      word.append(CONSONANTS.charAt(left % CONSONANTS.length()));
      left /= CONSONANTS.length();
      word.append(VOWELS.charAt(left % VOWELS.length()));
      left /= VOWELS.length();
    }
    return word + "lk";
  }

  /** The word that stands for this one; the same for the grammar's own. */
  String of(String word) {
    return invented.getOrDefault(word, word);
  }

  boolean hasOther(String word) {
    return invented.containsKey(word);
  }

  /** The same home, in which all is called otherwise. */
  Home home(Home home) {
    return new Home(
        home.iri(),
        home.label(),
        home.vocabulary(),
        home.individuals(),
        home.devices(),
        home.groups(),
        home.scripts(),
        home.rules(),
        home.timeZone(),
        with(home.wording(), this::translated),
        home.words(),
        home.file(),
        home.tracking());
  }

  private String translated(String text) {
    return PART.matcher(text)
        .replaceAll(
            part ->
                Matcher.quoteReplacement(
                    part.group().startsWith("{") ? part.group() : written(part.group())));
  }

  /** Words as they are written: what begins with a stroke, and a comma, follow without a blank. */
  private String written(String part) {
    StringBuilder all = new StringBuilder();
    for (String word : tokens.of(part)) {
      boolean follows = all.length() == 0 || !Character.isLetterOrDigit(word.charAt(0));
      all.append(follows ? "" : " ").append(of(word));
    }
    return all.toString();
  }

  private static Wording with(Wording wording, UnaryOperator<String> text) {
    List<StateWord> states = new ArrayList<>();
    for (StateWord state : wording.states()) {
      states.add(
          new StateWord(
              state.name(),
              said(state.says(), text),
              state.of(),
              state.holdsWhen(),
              state.broughtAboutBy(),
              said(state.foretells(), text)));
    }
    List<Construction> constructions = new ArrayList<>();
    for (Construction one : wording.constructions()) {
      constructions.add(
          new Construction(
              one.name(),
              said(one.says(), text),
              one.roles(),
              one.means(),
              one.holdsWhen(),
              one.early(),
              one.confirm(),
              one.inTheMorning()));
    }
    Map<String, Measure> measures = new TreeMap<>();
    wording
        .measures()
        .forEach(
            (name, one) ->
                measures.put(
                    name,
                    new Measure(
                        one.fluent(),
                        one.step(),
                        one.whole(),
                        one.grain(),
                        said(one.more(), text),
                        said(one.less(), text),
                        said(one.asked(), text),
                        one.timeOfDay())));
    return new Wording(
        wording.languages(),
        said(wording.names(), text),
        said(wording.prepositions(), text),
        wording.describing(),
        measures,
        states,
        constructions,
        wording.topics(),
        said(wording.told(), text),
        wording.grammars());
  }

  private static Map<String, List<Said>> said(
      Map<String, List<Said>> all, UnaryOperator<String> text) {
    Map<String, List<Said>> others = new TreeMap<>();
    all.forEach((name, said) -> others.put(name, said(said, text)));
    return others;
  }

  private static List<Said> said(List<Said> all, UnaryOperator<String> text) {
    return all.stream().map(one -> new Said(text.apply(one.text()), one.language())).toList();
  }
}
