package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;
import org.maestro.language.grammar.Template;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;

/**
 * Makes rules of constructions: a pattern becomes one for each form of its verb. One that begins
 * with a role tells what happens; one that begins with the verb of wishes is what may be wished.
 */
public final class ConstructionRules {
  private static final Pattern PART =
      Pattern.compile("\\[([^\\]]*)]|\\(([^)]*)\\)|\\{([^}]*)}|([^\\s\\[\\](){}]+)");
  private static final Map<String, String> CATEGORIES =
      Map.of(
          "Relation", "Where",
          "decimal", "Amount",
          "double", "Amount",
          "integer", "Amount",
          "duration", "Span",
          "time", "Clock",
          "string", "Text");

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
    if (parts.get(0).role()) {
      clause(construction, parts, made);
      return;
    }
    String verb = parts.get(0).text();
    if (parts.size() > 1 && grammar.list("want").contains(List.of(verb))) {
      made.accept(rule("WantTail", construction, parts.subList(1, parts.size())));
    }
    made.accept(rule("Vp", construction, parts));
    timed(construction, parts).ifPresent(made);
    for (String form : grammar.list("verb-forms").stream().map(words -> words.get(0)).toList()) {
      made.accept(rule("Vp" + category(form), construction, inflected(parts, 0, form)));
    }
  }

  /** Before what is said in any words it may be said when: remind me at six to feed the cat. */
  private static Optional<Rule> timed(Construction construction, List<Part> parts) {
    int text = parts.size() - 1;
    boolean isText =
        text > 1 && parts.get(text).role() && isOfText(construction, parts.get(text).text());
    if (!isText || parts.get(text - 1).role()) {
      return Optional.empty();
    }
    Rule whole = rule("Vp", construction, parts);
    List<Symbol> symbols = new ArrayList<>(whole.symbols());
    List<String> labels = new ArrayList<>(whole.labels());
    symbols.add(text - 1, new Symbol.Category("When"));
    labels.add(text - 1, "when");
    return Optional.of(
        new Rule(
            "Vp",
            symbols,
            labels,
            new Template.Node("later", List.of(new Template.Label("when"), whole.template())),
            0));
  }

  private static boolean isOfText(Construction construction, String role) {
    return construction.roles().stream()
        .anyMatch(one -> one.name().equals(role) && one.type().equals("string"));
  }

  private void clause(Construction construction, List<Part> parts, Consumer<Rule> made) {
    made.accept(rule("Clause", construction, parts));
    if (parts.size() > 1) {
      for (String form : grammar.list("verb-forms").stream().map(words -> words.get(0)).toList()) {
        made.accept(rule("Clause" + category(form), construction, inflected(parts, 1, form)));
      }
    }
  }

  private static String category(String form) {
    return Character.toUpperCase(form.charAt(0)) + form.substring(1);
  }

  private List<Part> inflected(List<Part> parts, int at, String form) {
    List<Part> others = new ArrayList<>(parts);
    if (!parts.get(at).role()) {
      others.set(at, new Part(grammar.inflection().of(parts.get(at).text(), form), false));
    }
    return others;
  }

  private static Rule rule(String category, Construction construction, List<Part> parts) {
    List<Symbol> symbols = new ArrayList<>();
    List<String> labels = new ArrayList<>();
    Map<String, Template> roles = new LinkedHashMap<>();
    for (Part part : parts) {
      if (!part.role()) {
        symbols.add(new Symbol.Word(part.text()));
        labels.add("");
        continue;
      }
      String type =
          construction.roles().stream()
              .filter(role -> role.name().equals(part.text()))
              .findFirst()
              .map(Construction.Role::type)
              .orElse("");
      symbols.add(new Symbol.Category(CATEGORIES.getOrDefault(type, "Np")));
      labels.add(part.text());
      roles.put(
          part.text(),
          new Template.Node(
              "role",
              List.of(new Template.Node(part.text(), List.of()), new Template.Label(part.text()))));
    }
    List<Template> frame = new ArrayList<>();
    frame.add(new Template.Node(construction.name(), List.of()));
    frame.addAll(roles.values());
    return new Rule(category, symbols, labels, new Template.Node("frame", frame), 0);
  }
}
