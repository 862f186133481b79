package org.maestro.planning.export;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.maestro.planning.cases.Clause;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The names of things in PDDL, which knows small letters, digits, {@code -} and {@code _}. */
final class PddlNames {
  private final Map<String, String> objects = new LinkedHashMap<>();
  private final Map<String, String> words = new LinkedHashMap<>();
  private final Map<String, Integer> predicates = new LinkedHashMap<>();
  private final Set<String> taken = new HashSet<>(Set.of("total-cost", "object", "number"));
  private final Set<Clause.Fact> used = new LinkedHashSet<>();

  /** A name made of any text. */
  static String plain(String text) {
    String name = text.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9_]+", "-");
    name = name.replaceAll("^-+|-+$", "");
    return name.isEmpty() || !Character.isLetter(name.charAt(0)) ? "x" + name : name;
  }

  private String fresh(String text) {
    String name = plain(text);
    String unique = name;
    for (int i = 2; !taken.add(unique); i++) {
      unique = name + "_" + i;
    }
    return unique;
  }

  String action(String text) {
    return fresh(text);
  }

  boolean isUsed(Clause.Fact fact) {
    return used.contains(fact);
  }

  String atom(Clause.Fact fact) {
    used.add(fact);
    if (fact instanceof Clause.Is is) {
      return atom("", is.variable().atom(is.value()));
    } else if (fact instanceof Clause.Open open) {
      return atom("may-be ", open.variable().atom(open.value()));
    } else if (fact instanceof Clause.Has has) {
      Expression.Fluent fluent = has.variable().fluent();
      return "(%s%s %s)"
          .formatted(
              predicate("value-of " + fluent.name(), fluent.arguments().size() + 1),
              arguments(fluent.arguments()),
              object(value(has.value())));
    }
    return "(" + predicate(((Clause.Said) fact).word(), 0) + ")";
  }

  private static String value(double value) {
    if (Quantity.isUnknown(value)) {
      return "unknown";
    }
    return Quantity.isAny(value)
        ? "measured"
        : "n" + PddlWriter.number(value).replace('-', 'm').replace('.', '_');
  }

  String function(NumberVariable variable) {
    Expression.Fluent fluent = variable.fluent();
    return "(%s)".formatted(word("number", SlPrinter.print(fluent)));
  }

  /** A function without arguments that tells how long something has gone on. */
  String clock(String text) {
    return "(%s)".formatted(word("clock", "clock " + text));
  }

  private String atom(String kind, Formula.Atom atom) {
    return "("
        + predicate(kind + atom.predicate(), atom.arguments().size())
        + arguments(atom.arguments())
        + ")";
  }

  private String arguments(List<Term> terms) {
    return terms.stream()
        .map(term -> " " + object(SlPrinter.print(term)))
        .collect(Collectors.joining());
  }

  private String predicate(String text, int arguments) {
    String name = word("predicate " + arguments, text);
    predicates.put(name, arguments);
    return name;
  }

  private String word(String kind, String text) {
    return words.computeIfAbsent(kind + " " + text, absent -> fresh(text));
  }

  private String object(String text) {
    return objects.computeIfAbsent(text, this::fresh);
  }

  /** The constants and predicates named up to now. */
  String declarations() {
    StringBuilder text = new StringBuilder();
    if (!objects.isEmpty()) {
      text.append("  (:constants ").append(String.join(" ", objects.values())).append(")\n");
    }
    text.append("  (:predicates");
    predicates.forEach(
        (name, count) -> text.append("\n    (").append(name).append(parameters(count)).append(')'));
    return text.append(")\n").toString();
  }

  private static String parameters(int count) {
    return IntStream.rangeClosed(1, count).mapToObj(i -> " ?x" + i).collect(Collectors.joining());
  }
}
