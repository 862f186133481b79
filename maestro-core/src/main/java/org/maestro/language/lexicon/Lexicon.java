package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.maestro.language.chart.WordEntries;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.sl.SlPrinter;

/**
 * The entries of a home in a language. Immutable; numbers are entries too, and each word is one of
 * the category {@link #ANY}.
 */
public final class Lexicon implements WordEntries {
  /** A name of a thing: {@code (name Cup)}. */
  public static final String NAME = "Name";

  /** A class: {@code (noun Lamp)}. */
  public static final String NOUN = "Noun";

  /** A class of which there are several: {@code (noun Lamp)}. */
  public static final String NOUNS = "Nouns";

  /** What a thing is like: {@code (adj colour red)}. */
  public static final String ADJECTIVE = "Adjective";

  /** What things are like, as a kind: {@code (attribute colour)}. */
  public static final String ATTRIBUTE = "Attribute";

  /** A relation: {@code (prep in inside)}. */
  public static final String PREPOSITION = "Preposition";

  /** A number that can be spoken of: {@code (fluent volume)}. */
  public static final String FLUENT = "Fluent";

  /** More of a number. */
  public static final String MORE = "More";

  /** Less of a number. */
  public static final String LESS = "Less";

  /** More of a number than all others. */
  public static final String MOST = "Most";

  /** Less of a number than all others. */
  public static final String LEAST = "Least";

  /** What is asked for with how. */
  public static final String HOW_MUCH = "HowMuch";

  /** What is said of that of which there is much, such as bright. */
  public static final String HIGH = "High";

  /** A name of somebody to whom one speaks: a robot. */
  public static final String ADDRESSEE = "Addressee";

  /** A name of a room, to which one may speak from another one: {@code (name kitchen)}. */
  public static final String ROOM = "Room";

  /** A word for a state that is one for things, too, such as light. */
  public static final String NOUN_STATE = "NounState";

  /** The opposite of {@link #HIGH}, such as dark. */
  public static final String LOW = "Low";

  /** A state: {@code (state lampOn applianceOn)}. */
  public static final String STATE = "State";

  /** A state as it is said of what follows, in languages that tell both apart. */
  public static final String STATE_FORM = "StateForm";

  /** Whose something is, by his name, in languages that have a form for it. */
  public static final String NAME_OWNING = "NameOwning";

  /** A script: {@code (script goodNight)}. */
  public static final String SCRIPT = "Script";

  /** A number. */
  public static final String NUMBER = "Number";

  /** So much of something, as a grammar's rules have it. */
  public static final String AMOUNT = "Amount";

  /** A time of day in figures, such as 10:30. */
  public static final String TIME = "Time";

  private static final Pattern FIGURES_OF_TIME = Pattern.compile("([01]?\\d|2[0-3]):[0-5]\\d");
  private static final int LONGEST_NUMBER = 8;
  private final Map<List<String>, Map<String, List<Form>>> entries;
  private final Map<List<String>, Set<String>> beginnings = new HashMap<>();
  private final FollowingWords following = new FollowingWords();
  private final SpokenNumbers numbers;
  private final Set<String> words = new HashSet<>();
  private final Set<List<String>> subordinating;
  private final int longest;

  /**
   * @param present whether there is anything of which an entry speaks; what speaks of nothing is
   *     understood, and not suggested
   */
  Lexicon(
      Map<List<String>, Map<String, List<Form>>> entries,
      Grammar grammar,
      Predicate<Form> present) {
    this.entries = entries;
    NumberWords whole =
        new NumberWords(
            grammar.numbers(),
            grammar.times(),
            grammar.list("joining"),
            grammar.list("turning"),
            grammar.list("singular"));
    this.numbers =
        new SpokenNumbers(
            whole,
            grammar.list("negative"),
            grammar.list("decimal"),
            grammar.list("halving"),
            grammar.list("noughts"));
    this.subordinating = grammar.list("subordinating");
    int most = LONGEST_NUMBER;
    for (Map.Entry<List<String>, Map<String, List<Form>>> entry : entries.entrySet()) {
      List<String> written = entry.getKey();
      words.addAll(written);
      most = Math.max(most, written.size());
      for (int size = 1; size < written.size(); size++) {
        beginnings
            .computeIfAbsent(List.copyOf(written.subList(0, size)), b -> new HashSet<>())
            .addAll(entry.getValue().keySet());
      }
    }
    entries.forEach(
        (written, meanings) ->
            meanings.forEach(
                (category, forms) -> {
                  if (forms.stream().anyMatch(present)) {
                    following.add(written, category);
                  }
                }));
    whole.words().forEach(word -> following.add(List.of(word), NUMBER));
    this.longest = most;
  }

  @Override
  public List<Entry> endingWith(List<String> words) {
    List<Entry> found = new ArrayList<>();
    int most = Math.min(longest, words.size());
    String latest = words.get(words.size() - 1);
    found.add(new Entry(ANY, 1, Form.leaf(latest)));
    if (!subordinating.contains(List.of(latest))) {
      found.add(new Entry(OPENING, 1, Form.leaf(latest)));
    }
    if (FIGURES_OF_TIME.matcher(latest).matches()) {
      found.add(new Entry(TIME, 1, Form.leaf(latest)));
    }
    for (int size = 1; size <= most; size++) {
      List<String> last = words.subList(words.size() - size, words.size());
      int taken = size;
      entries
          .getOrDefault(last, Map.of())
          .forEach(
              (category, forms) ->
                  forms.forEach(form -> found.add(new Entry(category, taken, form))));
      OptionalDouble number = size <= LONGEST_NUMBER ? numbers.value(last) : OptionalDouble.empty();
      if (number.isPresent()) {
        found.add(new Entry(NUMBER, size, Form.leaf(SlPrinter.print(number.getAsDouble()))));
      }
    }
    return found;
  }

  @Override
  public boolean isBeginning(List<String> words, Predicate<String> categories) {
    return beginnings.getOrDefault(words, Set.of()).stream().anyMatch(categories)
        || categories.test(NUMBER) && numbers.isBeginning(words);
  }

  @Override
  public int longest() {
    return longest;
  }

  @Override
  public Set<String> next(
      List<String> words, Predicate<String> categories, String begin, int most) {
    return following.after(words, categories, begin, most);
  }

  /** Whether the word is one of an entry. */
  public boolean knows(String word) {
    return words.contains(word) || numbers.knows(word) || FIGURES_OF_TIME.matcher(word).matches();
  }

  /** Each word that stands in an entry. */
  public Set<String> words() {
    return Collections.unmodifiableSet(words);
  }

  /** All entries as text, with what they mean, by category. */
  public Map<String, Map<String, Set<String>>> listed() {
    Map<String, Map<String, Set<String>>> listed = new TreeMap<>();
    entries.forEach(
        (written, meanings) ->
            meanings.forEach(
                (category, forms) ->
                    forms.forEach(
                        form ->
                            listed
                                .computeIfAbsent(category, c -> new TreeMap<>())
                                .computeIfAbsent(String.join(" ", written), w -> new TreeSet<>())
                                .add(form.toString()))));
    return listed;
  }
}
