package org.maestro.coordination.facts;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The ground facts under a precondition with their present values, as one comparable text: a line
 * for each.
 */
public final class FactsUnder {

  private FactsUnder() {}

  public static String of(Formula precondition, Map<String, Term> bindings, Snapshot snapshot) {
    Map<String, String> values = new TreeMap<>();
    Leaves.of(
        new Substitution(bindings).apply(precondition),
        atom -> {
          if (atom.isGround()) {
            values.put(SlPrinter.print(atom), snapshot.truth(atom).toString());
          }
        },
        fluent -> {
          if (fluent.arguments().stream().allMatch(Term::isGround)) {
            values.put(SlPrinter.print(fluent), number(snapshot.number(fluent)));
          }
        });
    return text(values);
  }

  /** These facts beside those. */
  public static String with(String facts, Collection<Formula.Atom> also, Snapshot snapshot) {
    Map<String, String> values = values(facts);
    for (Formula.Atom fact : also) {
      OptionalDouble number =
          snapshot.number(new Expression.Fluent(fact.predicate(), fact.arguments()));
      values.putIfAbsent(
          SlPrinter.print(fact),
          number.isPresent() ? number(number) : snapshot.truth(fact).toString());
    }
    return text(values);
  }

  /** The facts as they were before, but those that were taught meanwhile as they are after it. */
  public static String asTaught(String before, String after, Collection<Formula.Atom> taught) {
    Map<String, String> values = values(before);
    Map<String, String> now = values(after);
    for (Formula.Atom fact : taught) {
      String name = SlPrinter.print(fact);
      if (now.containsKey(name)) {
        values.put(name, now.get(name));
      }
    }
    return text(values);
  }

  /**
   * Whether nothing is otherwise: truths are the same, and numbers differ by no more than readings
   * of the same number do.
   */
  public static boolean areSame(String some, String others) {
    Map<String, String> one = values(some);
    Map<String, String> other = values(others);
    BiFunction<String, String, Boolean> alike =
        (a, b) -> a.equals(b) || isNumber(a) && isNumber(b) && areClose(a, b);
    return one.keySet().equals(other.keySet())
        && one.keySet().stream().allMatch(fact -> alike.apply(one.get(fact), other.get(fact)));
  }

  private static boolean areClose(String some, String other) {
    double one = Double.parseDouble(some);
    double two = Double.parseDouble(other);
    return Math.abs(one - two) <= Tightened.MARGIN * Math.max(Math.abs(one), Math.abs(two));
  }

  private static boolean isNumber(String value) {
    return !value.isEmpty() && "-.0123456789".indexOf(value.charAt(0)) >= 0;
  }

  private static String number(OptionalDouble number) {
    return number.isPresent() ? SlPrinter.print(number.getAsDouble()) : "UNKNOWN";
  }

  private static String text(Map<String, String> values) {
    return values.entrySet().stream()
        .map(entry -> entry.getKey() + "=" + entry.getValue())
        .collect(Collectors.joining("\n"));
  }

  private static Map<String, String> values(String text) {
    Map<String, String> values = new TreeMap<>();
    for (String line : List.of(text.split("\n"))) {
      int equals = line.lastIndexOf('=');
      values.put(line.substring(0, Math.max(0, equals)), line.substring(equals + 1));
    }
    return values;
  }
}
