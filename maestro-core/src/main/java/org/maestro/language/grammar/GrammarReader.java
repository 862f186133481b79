package org.maestro.language.grammar;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Reads a grammar's file, line by line. A rule is {@code Category = item item -> (form label)},
 * where an item is a word, {@code one/other}, a Category, {@code label:Category}, and may end in
 * {@code ?} when it need not be said; {@code !2} at the end is a penalty. Other lines begin with a
 * keyword. A grammar may be built on another one, or have its phrases from it.
 */
public final class GrammarReader {
  private static final Pattern RULE =
      Pattern.compile("([A-Z]\\w*)\\s+=\\s+(.*?)(?:\\s+->\\s+(.*?))?(?:\\s+!(\\d+))?");

  /** How lists write what parts their entries. */
  private static final String COMMA = "comma";

  private static final int LONGEST_PENALTY = 4;

  private static final Pattern REPORT = Pattern.compile("([A-Z]\\w*)\\s+(.*?)\\s+([-=])>\\s+(.*)");
  private static final Pattern PLACE = Pattern.compile("\\{(\\w+)[^{}]*}");

  private final String file;
  private final List<Rule> rules = new ArrayList<>();
  private final List<Rule> patterns = new ArrayList<>();
  private final Map<String, List<Inflection.Ending>> endings = new LinkedHashMap<>();
  private final Map<String, Map<String, String>> irregular = new LinkedHashMap<>();
  private final Map<String, Double> numbers = new LinkedHashMap<>();
  private final Map<String, Double> times = new HashMap<>();
  private final Map<String, Set<List<String>>> lists = new HashMap<>();
  private final Map<String, String> phrases = new HashMap<>();
  private final Map<String, String> spellings = new HashMap<>();
  private final List<ReportRule> reports = new ArrayList<>();
  private final Function<String, Optional<String>> others;
  private Optional<String> phrasesLike = Optional.empty();
  private String language = "";
  private int line;

  private GrammarReader(String file, Function<String, Optional<String>> others) {
    this.file = file;
    this.others = others;
  }

  /**
   * The grammar of a text.
   *
   * @param file how faults call it
   * @throws GrammarFaultException when a line cannot be read
   */
  public static Grammar read(String text, String file) {
    return read(text, file, tag -> Optional.empty());
  }

  /**
   * The grammar of a text that may be built on others.
   *
   * @param file how faults call it
   * @param others texts of grammars by their language's tag
   * @throws GrammarFaultException when a line cannot be read
   */
  public static Grammar read(String text, String file, Function<String, Optional<String>> others) {
    GrammarReader reader = new GrammarReader(file, others);
    reader.takeAll(text);
    reader
        .phrasesLike
        .map(tag -> read(reader.other(tag), tag))
        .ifPresent(other -> other.phrases().forEach(reader.phrases::putIfAbsent));
    return reader.grammar();
  }

  private void takeAll(String text) {
    for (String written : text.split("\n", -1)) {
      line++;
      takeLine(written);
    }
  }

  private void takeLine(String written) {
    String content = written.replaceFirst("(^|\\s)#\\s.*$", "").strip();
    if (!content.isEmpty()) {
      take(content);
    }
  }

  private Grammar grammar() {
    if (language.isEmpty()) {
      throw fault("names no language", "write a line such as language en");
    }
    return new Grammar(
        language,
        rules,
        patterns,
        new Inflection(endings, irregular),
        numbers,
        times,
        lists,
        phrases,
        spellings,
        reports);
  }

  /** All that the other grammar says is said in this line. */
  private void like(String tag) {
    String own = language;
    for (String written : other(tag).split("\n", -1)) {
      takeLine(written);
    }
    language = own;
  }

  private String other(String tag) {
    return others
        .apply(tag)
        .orElseThrow(
            () -> fault("there is no grammar " + tag, "name one that is shipped, such as en"));
  }

  private void phrasesLike(String rest) {
    if (!rest.matches("like \\S+")) {
      throw fault("does not say whose phrases", "write phrases like en");
    }
    phrasesLike = Optional.of(rest.substring(rest.indexOf(' ') + 1));
  }

  private void take(String content) {
    Matcher rule = RULE.matcher(content);
    if (rule.matches()) {
      String template = rule.group(3) == null ? "" : rule.group(3);
      rule(rules, rule.group(1), rule.group(2), template, penalty(rule.group(4)));
      return;
    }
    int blank = content.indexOf(' ');
    String keyword = blank < 0 ? content : content.substring(0, blank);
    String rest = blank < 0 ? "" : content.substring(blank + 1).strip();
    switch (keyword) {
      case "language" -> language = rest;
      case "like" -> like(rest);
      case "phrases" -> phrasesLike(rest);
      case "ending" -> ending(rest);
      case "irregular" -> irregular(rest);
      case "number" -> pair(rest, (word, value) -> numbers.put(word, number(value)));
      case "times" -> pair(rest, (word, value) -> times.put(word, number(value)));
      case "spelling" -> pair(rest, spellings::put);
      case "phrase" -> pair(rest, phrases::put);
      case "list" -> list(rest);
      case "pattern" -> pattern(rest);
      case "report" -> report(rest);
      default ->
          throw fault(
              "begins with " + keyword,
              "write a rule such as Act = v:Vp -> (do v), or language, like, phrases, pattern, ending,"
                  + " irregular, number, times, list, spelling, phrase or report");
    }
  }

  private int penalty(@Nullable String written) {
    if (written != null && written.length() > LONGEST_PENALTY) {
      throw fault("!" + written + " is too much", "write a penalty such as !2");
    }
    return written == null ? 0 : Integer.parseInt(written);
  }

  private GrammarFaultException fault(String problem, String cure) {
    return new GrammarFaultException(file, line, problem, cure);
  }

  private void pair(String rest, BiConsumer<String, String> taken) {
    String[] sides = rest.split("\\s*=\\s*", 2);
    if (sides.length < 2) {
      throw fault("has no = in it", "write the word, = and what it is");
    }
    if (sides[0].isEmpty() || sides[1].isEmpty()) {
      throw fault("has nothing beside its =", "write the word, = and what it is");
    }
    taken.accept(sides[0], sides[1]);
  }

  private double number(String text) {
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // It is told below, as what is not finite is.
    }
    throw fault(text + " is no number", "write one such as 20");
  }

  private void list(String rest) {
    pair(
        rest,
        (name, words) -> {
          Set<List<String>> entries = lists.computeIfAbsent(name, n -> new LinkedHashSet<>());
          for (String entry : words.split("\\s*,\\s*", -1)) {
            if (entry.isEmpty()) {
              throw fault("has a comma with nothing beside it", "write comma where , is meant");
            }
            entries.add(entry.equals(COMMA) ? List.of(",") : List.of(entry.split("\\s+")));
          }
        });
  }

  private void ending(String rest) {
    String[] parts = rest.split("\\s+");
    if (parts.length < 2 || parts.length > 3) {
      throw fault("is no ending", "write its form, a pattern and what replaces it: ing e$ ing");
    }
    String replacement = parts.length == 3 ? parts[2] : "";
    try {
      Pattern fits = Pattern.compile(parts[1]);
      int groups = Math.min(9, fits.matcher("").groupCount());
      if (!replacement.matches("([^$\\\\]|\\$[0-" + groups + "])*")) {
        throw fault(
            replacement + " names no group of " + parts[1], "write $1 for what its ( ) enclose");
      }
      endings
          .computeIfAbsent(parts[0], form -> new ArrayList<>())
          .add(new Inflection.Ending(fits, replacement));
    } catch (PatternSyntaxException e) {
      throw fault(parts[1] + " is no pattern", "write a regular expression such as e$");
    }
  }

  private void irregular(String rest) {
    pair(
        rest,
        (form, words) -> {
          for (String entry : words.split("\\s*,\\s*")) {
            String[] sides = entry.split("\\s+");
            if (sides.length != 2) {
              throw fault(entry + " is no pair of words", "write put put");
            }
            irregular.computeIfAbsent(form, f -> new HashMap<>()).put(sides[0], sides[1]);
          }
        });
  }

  /** A pattern is a rule, with places in it that each construction fills. */
  private void pattern(String rest) {
    Matcher rule = RULE.matcher(rest);
    if (!rule.matches()) {
      throw fault("is no pattern", "write one such as pattern Vp = VERB REST");
    }
    String template = rule.group(3) == null ? ConstructionPlaces.FRAME : rule.group(3);
    rule(patterns, rule.group(1), rule.group(2), template, penalty(rule.group(4)));
  }

  private void report(String rest) {
    Matcher report = REPORT.matcher(rest);
    if (!report.matches()) {
      throw fault(
          "is no report", "write one such as report Fact {x:thing} is missing => {x} fehlt");
    }
    String text = report.group(2);
    Set<String> places =
        PLACE.matcher(text).results().map(place -> place.group(1)).collect(Collectors.toSet());
    PLACE
        .matcher(report.group(4))
        .results()
        .map(place -> place.group(1))
        .filter(place -> !places.contains(place))
        .findFirst()
        .ifPresent(
            place -> {
              throw fault(
                  "{" + place + "} is no place of what is reported",
                  "write {" + place + ":thing} where it stands there");
            });
    reports.add(
        new ReportRule(report.group(1), text, report.group(4), report.group(3).equals("-"), line));
  }

  private void rule(List<Rule> into, String category, String items, String template, int penalty) {
    if (items.contains("->")) {
      throw fault("has no items before its ->", "write what is said between = and ->");
    }
    List<Item> read = Arrays.stream(items.split("\\s+")).map(this::item).toList();
    Set<String> labels = new LinkedHashSet<>();
    read.stream().map(Item::label).filter(label -> !label.isEmpty()).forEach(labels::add);
    Template meaning =
        template.isEmpty()
            ? silent(labels)
            : Template.of(new FormText(template, this::fault).form(), labels);
    expand(
        read,
        0,
        new ArrayList<>(),
        chosen -> {
          List<Choice> words = chosen.stream().flatMap(Choice::ofWords).toList();
          into.add(
              new Rule(
                  category,
                  words.stream().map(Choice::symbol).toList(),
                  words.stream().map(Choice::label).toList(),
                  meaning,
                  penalty,
                  line));
        });
  }

  /** Without a form, a rule means what its only category means, or nothing of interest. */
  private Template silent(Set<String> labels) {
    if (labels.size() > 1) {
      throw fault("does not say what it means", "write -> and a form after the items");
    }
    return labels.isEmpty()
        ? new Template.Node("word", List.of())
        : new Template.Label(labels.iterator().next());
  }

  /** What is written in the place of one symbol. */
  private record Item(String label, List<Symbol> alternatives, boolean optional) {}

  private record Choice(String label, Symbol symbol) {
    /** Of several words each is a symbol. */
    Stream<Choice> ofWords() {
      return symbol instanceof Symbol.Word words
          ? Arrays.stream(words.text().split(" "))
              .map(word -> new Choice(label, new Symbol.Word(word)))
          : Stream.of(this);
    }
  }

  private Item item(String written) {
    boolean optional = written.endsWith("?") && written.length() > 1;
    String text = optional ? written.substring(0, written.length() - 1) : written;
    int colon = text.indexOf(':');
    String label = colon > 0 ? text.substring(0, colon) : "";
    String symbols = colon > 0 ? text.substring(colon + 1) : text;
    List<Symbol> alternatives =
        Arrays.stream(symbols.split("/")).filter(one -> !one.isEmpty()).map(this::symbol).toList();
    if (alternatives.isEmpty()) {
      throw fault(written + " is no item", "write a word or a Category");
    }
    String named =
        label.isEmpty() && alternatives.get(0) instanceof Symbol.Category ? symbols : label;
    return new Item(colon > 0 ? label : named, alternatives, optional);
  }

  private Symbol symbol(String text) {
    return Character.isUpperCase(text.charAt(0))
        ? new Symbol.Category(text)
        : new Symbol.Word(text.replace('_', ' ').strip());
  }

  private static void expand(
      List<Item> items, int at, List<Choice> chosen, Consumer<List<Choice>> found) {
    if (at == items.size()) {
      if (!chosen.isEmpty()) {
        found.accept(List.copyOf(chosen));
      }
      return;
    }
    Item item = items.get(at);
    for (Symbol symbol : item.alternatives()) {
      chosen.add(new Choice(item.label(), symbol));
      expand(items, at + 1, chosen, found);
      chosen.remove(chosen.size() - 1);
    }
    if (item.optional()) {
      expand(items, at + 1, chosen, found);
    }
  }
}
