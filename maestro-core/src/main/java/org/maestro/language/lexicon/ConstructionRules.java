package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.maestro.language.grammar.ConstructionPlaces;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;
import org.maestro.language.grammar.Template;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;

/**
 * Makes rules of constructions by the grammar's patterns. One that begins with a role before its
 * verb tells what happens; one whose verb is that of wishes is what may be wished.
 */
public final class ConstructionRules {
  private static final Pattern PART =
      Pattern.compile("\\[([^\\]]*)]|\\(([^)]*)\\)|\\{([^}]*)}|([^\\s\\[\\](){}]+)");
  private static final String WORDS = "Text";

  private static final Map<String, String> CATEGORIES =
      Map.of(
          Construction.Role.RELATION,
          "Where",
          Construction.Role.CONDITION,
          "Cond",
          "decimal",
          Lexicon.AMOUNT,
          "double",
          Lexicon.AMOUNT,
          "integer",
          Lexicon.AMOUNT,
          "duration",
          "Span",
          "time",
          "Clock",
          "string",
          WORDS);

  private static final String TEXT = "string";

  /** What is wished: it is made of verbs of wishing only. */
  private static final String WISHED = "WantTail";

  /** Stands between a verb and what may be parted from it. */
  private static final char PARTING = '-';

  private final Grammar grammar;
  private final Tokens tokens;

  public ConstructionRules(Grammar grammar) {
    this.grammar = grammar;
    this.tokens = new Tokens(grammar.spellings());
  }

  /** The rules of all constructions. */
  public List<Rule> of(List<Construction> constructions) {
    List<Rule> rules = new ArrayList<>();
    for (Construction construction : constructions) {
      for (Said said : construction.says()) {
        if (said.isIn(grammar.language())) {
          for (List<Part> parts : variants(said.text())) {
            rules(construction, parts, rules::add);
          }
        }
      }
    }
    return rules;
  }

  /** A word or a role of a pattern. */
  private record Part(String text, boolean role) {}

  private List<List<Part>> variants(String pattern) {
    List<List<Part>> all = new ArrayList<>(List.of(List.of()));
    Matcher part = PART.matcher(pattern);
    while (part.find()) {
      List<List<Part>> choices = new ArrayList<>();
      if (part.group(1) != null) {
        choices.addAll(variants(part.group(1)));
        choices.add(List.of());
      } else if (part.group(2) != null) {
        Arrays.stream(part.group(2).split("\\|")).forEach(one -> choices.addAll(variants(one)));
      } else if (part.group(3) != null) {
        choices.add(List.of(new Part(part.group(3), true)));
      } else {
        choices.add(tokens.of(part.group(4)).stream().map(word -> new Part(word, false)).toList());
      }
      all = joined(all, choices);
    }
    return all.stream().filter(parts -> !parts.isEmpty()).toList();
  }

  private static List<List<Part>> joined(List<List<Part>> before, List<List<Part>> choices) {
    List<List<Part>> all = new ArrayList<>();
    for (List<Part> begun : before) {
      for (List<Part> choice : choices) {
        List<Part> longer = new ArrayList<>(begun);
        longer.addAll(choice);
        all.add(List.copyOf(longer));
      }
    }
    return all;
  }

  private void rules(Construction construction, List<Part> parts, Consumer<Rule> made) {
    boolean isVerbLast = grammar.list("verb-place").contains(List.of("last"));
    boolean tells = parts.get(0).role() && (!isVerbLast || construction.means().isEmpty());
    if (isVerbLast && !parts.get(0).role() && parts.get(parts.size() - 1).role()) {
      Filling whole = new Filling("", List.of(), parts, -1);
      grammar.patterns().stream()
          .filter(pattern -> stands(ConstructionPlaces.WHOLE, pattern))
          .forEach(pattern -> made.accept(rule(pattern, construction, whole)));
      return;
    }
    int verbAt = isVerbLast ? parts.size() - 1 : tells ? 1 : 0;
    if (verbAt >= parts.size() || parts.get(verbAt).role() || tells && verbAt == 0) {
      return;
    }
    List<Part> rest = new ArrayList<>(parts);
    String verb = rest.remove(verbAt).text();
    List<Part> subject = tells ? List.of(rest.remove(0)) : List.of();
    Filling filling = new Filling(verb, subject, rest, textAt(construction, rest));
    boolean isWish = grammar.list("want").contains(List.of(verb)) && !rest.isEmpty();
    for (Rule pattern : grammar.patterns()) {
      boolean mayBe =
          !stands(ConstructionPlaces.WHOLE, pattern)
              && (isWish || !pattern.category().equals(WISHED))
              && (filling.textAt() >= 0 || !stands(ConstructionPlaces.SAYING, pattern))
              && (isOfAnObject(construction, rest) || !stands(ConstructionPlaces.OBJECT, pattern));
      if (mayBe && tells == stands(ConstructionPlaces.SUBJECT, pattern)) {
        Rule rule = rule(pattern, construction, filling);
        // Whatever is said may be any words: nothing that is meant otherwise would be heard then.
        if (!rule.symbols().get(0).equals(new Symbol.Category(WORDS))) {
          made.accept(rule);
        }
      }
    }
  }

  /** Whether something is done to a thing or person, and is not only said or a number. */
  private static boolean isOfAnObject(Construction construction, List<Part> rest) {
    return !rest.isEmpty()
        && rest.get(0).role()
        && construction.roles().stream()
            .filter(role -> role.name().equals(rest.get(0).text()))
            .noneMatch(role -> CATEGORIES.containsKey(role.type()));
  }

  private static boolean stands(String place, Rule pattern) {
    return pattern.symbols().contains(new Symbol.Category(place));
  }

  /** Where the word stands that begins what is said in any words at the end; -1 for nowhere. */
  private static int textAt(Construction construction, List<Part> rest) {
    int last = rest.size() - 1;
    boolean isText =
        last > 0
            && rest.get(last).role()
            && !rest.get(last - 1).role()
            && construction.roles().stream()
                .filter(role -> role.name().equals(rest.get(last).text()))
                .anyMatch(role -> role.type().equals(TEXT));
    return isText ? last - 1 : -1;
  }

  /**
   * What fills the places of a grammar's pattern.
   *
   * @param textAt from where on in the rest something is said in any words; -1 for nowhere
   */
  private record Filling(String verb, List<Part> subject, List<Part> rest, int textAt) {}

  /** A symbol, and by which label what it means is called. */
  private record Labelled(String label, Symbol symbol) {}

  private Rule rule(Rule pattern, Construction construction, Filling filling) {
    List<Labelled> items = new ArrayList<>();
    for (int i = 0; i < pattern.symbols().size(); i++) {
      Symbol symbol = pattern.symbols().get(i);
      String place = symbol instanceof Symbol.Category category ? category.name() : "";
      if (place.equals(ConstructionPlaces.REST) || place.equals(ConstructionPlaces.WHOLE)) {
        filling.rest().forEach(part -> items.add(item(construction, part)));
      } else if (place.equals(ConstructionPlaces.BEFORE)) {
        filling
            .rest()
            .subList(0, filling.textAt())
            .forEach(part -> items.add(item(construction, part)));
      } else if (place.equals(ConstructionPlaces.SAYING)) {
        filling
            .rest()
            .subList(filling.textAt(), filling.rest().size())
            .forEach(part -> items.add(item(construction, part)));
      } else if (place.equals(ConstructionPlaces.OBJECT)) {
        items.add(item(construction, filling.rest().get(0)));
      } else if (place.equals(ConstructionPlaces.OTHERS)) {
        filling
            .rest()
            .subList(1, filling.rest().size())
            .forEach(part -> items.add(item(construction, part)));
      } else if (place.equals(ConstructionPlaces.SUBJECT)) {
        filling.subject().forEach(part -> items.add(item(construction, part)));
      } else if (place.contains(ConstructionPlaces.VERB)
          || place.contains(ConstructionPlaces.PARTICLE)) {
        tokens
            .of(verb(place, filling.verb()))
            .forEach(word -> items.add(new Labelled("", new Symbol.Word(word))));
      } else {
        items.add(new Labelled(pattern.labels().get(i), symbol));
      }
    }
    return new Rule(
        pattern.category(),
        items.stream().map(Labelled::symbol).toList(),
        items.stream().map(Labelled::label).toList(),
        filled(pattern.template(), frame(construction, filling)),
        pattern.penalty(),
        pattern.line());
  }

  /** A form of the verb, with what may be parted from it, as the place says. */
  private String verb(String place, String verb) {
    int parting = isParted() ? verb.indexOf(PARTING) : -1;
    String particle = parting < 0 ? "" : verb.substring(0, parting);
    String stem = verb.substring(parting + 1);
    StringBuilder word = new StringBuilder();
    for (String part : place.split("\\+")) {
      int dot = part.indexOf('.');
      if (part.equals(ConstructionPlaces.PARTICLE)) {
        word.append(particle);
      } else {
        word.append(dot < 0 ? stem : grammar.inflection().of(stem, part.substring(dot + 1)));
      }
    }
    return word.toString();
  }

  private boolean isParted() {
    return grammar.patterns().stream()
        .anyMatch(pattern -> stands(ConstructionPlaces.PARTICLE, pattern));
  }

  private static Labelled item(Construction construction, Part part) {
    if (!part.role()) {
      return new Labelled("", new Symbol.Word(part.text()));
    }
    String type =
        construction.roles().stream()
            .filter(role -> role.name().equals(part.text()))
            .findFirst()
            .map(Construction.Role::type)
            .orElse("");
    return new Labelled(part.text(), new Symbol.Category(CATEGORIES.getOrDefault(type, "Np")));
  }

  private static Template frame(Construction construction, Filling filling) {
    List<Template> frame = new ArrayList<>();
    frame.add(new Template.Node(construction.name(), List.of()));
    Stream.concat(filling.subject().stream(), filling.rest().stream())
        .filter(Part::role)
        .map(Part::text)
        .distinct()
        .forEach(
            role ->
                frame.add(
                    new Template.Node(
                        "role",
                        List.of(new Template.Node(role, List.of()), new Template.Label(role)))));
    return new Template.Node("frame", frame);
  }

  /** The pattern's meaning with the construction's in its place. */
  private static Template filled(Template template, Template frame) {
    if (template instanceof Template.Node node) {
      return node.head().equals(ConstructionPlaces.FRAME)
          ? frame
          : new Template.Node(
              node.head(), node.parts().stream().map(part -> filled(part, frame)).toList());
    }
    return template;
  }
}
