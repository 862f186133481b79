package org.maestro.coordination.api;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Point;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Puts facts, steps and obstacles into plain sentences, by the labels and sentences of the
 * vocabulary.
 */
public final class Sentences {
  private static final Pattern PLACE_HOLDER = Pattern.compile("\\{([A-Za-z][A-Za-z0-9-]*)}");

  private static final Pattern COORDINATES = Pattern.compile("[-+.\\d\\s]*\\d[-+.\\d\\s]*");

  /** What is larger is told by its power of ten. */
  private static final double MOST_IN_FULL = 1e15;

  private static final double TENTH = 0.1;

  private final Vocabulary vocabulary;

  public Sentences(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  /** A fact as it stands in a belief or a change. */
  public String fact(String slText) {
    return fact(SlParser.formula(slText, vocabulary::isFluent));
  }

  public String fact(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return atom(atom, false);
    }
    if (formula instanceof Formula.Not not && not.operand() instanceof Formula.Atom atom) {
      return atom(atom, true);
    }
    if (formula instanceof Formula.UnknownAtom unknown) {
      return "it is no longer known whether " + atom(unknown.atom(), false);
    }
    if (formula instanceof Formula.UnknownNumber unknown) {
      return quantity(unknown.fluent()) + " is no longer known";
    }
    if (formula instanceof Formula.Comparison comparison
        && comparison.left() instanceof Expression.Fluent fluent) {
      String verb =
          comparison.relation() == Formula.Relation.EQUAL
              ? " is "
              : " " + comparison.relation().symbol() + " ";
      return quantity(fluent) + verb + value(comparison.right()) + unit(fluent);
    }
    return SlPrinter.print(formula);
  }

  public String step(Step step) {
    Matcher matcher = PLACE_HOLDER.matcher(step.feature().sentence());
    return matcher.replaceAll(
        found -> {
          String name = found.group(1);
          Term term =
              name.equals(Self.NAME) ? new Term.Name(step.member()) : step.bindings().get(name);
          return Matcher.quoteReplacement(term == null ? "?" : term(term));
        });
  }

  public String plan(List<Step> steps) {
    return steps.stream()
        .map(step -> step.number() + ". " + step(step))
        .collect(Collectors.joining("; "));
  }

  public String binding(Map<String, Term> binding) {
    return binding.entrySet().stream()
        .map(e -> "?" + e.getKey() + " = " + term(e.getValue()))
        .collect(Collectors.joining(", "));
  }

  private String atom(Formula.Atom atom, boolean negated) {
    List<String> terms = atom.arguments().stream().map(Sentences::term).toList();
    Optional<String> label =
        vocabulary.predicate(atom.predicate()).map(PredicateDeclaration::label);
    if (label.isEmpty() || terms.isEmpty()) {
      String kind =
          Optional.ofNullable(vocabulary.classes().get(atom.predicate()))
              .map(c -> c.label())
              .orElse(atom.predicate());
      return String.join(", ", terms) + (negated ? " is not " : " is ") + "a " + kind;
    }
    return terms.get(0)
        + verb(label.get(), negated)
        + (terms.size() > 1 ? " " + String.join(", ", terms.subList(1, terms.size())) : "");
  }

  /** Labels are such as "in", "next to", "can see". */
  private static String verb(String label, boolean negated) {
    if (label.startsWith("can ")) {
      return negated ? " cannot" + label.substring(3) : " " + label;
    }
    return (negated ? " is not " : " is ") + label;
  }

  public String quantity(Expression.Fluent fluent) {
    String label =
        vocabulary.predicate(fluent.name()).map(PredicateDeclaration::label).orElse(fluent.name());
    return "the "
        + label
        + " of "
        + fluent.arguments().stream().map(Sentences::term).collect(Collectors.joining(", "));
  }

  public String unit(Expression.Fluent fluent) {
    return vocabulary
        .predicate(fluent.name())
        .map(PredicateDeclaration::unitAfterNumber)
        .orElse("");
  }

  /** A sentence to stand within another one; three dots are no full stop. */
  public static String withoutFullStop(String sentence) {
    String stripped = sentence.strip();
    return stripped.endsWith(".") && !stripped.endsWith("..")
        ? stripped.substring(0, stripped.length() - 1)
        : stripped;
  }

  /** That they say something, without what. */
  public static String say(Collection<String> members) {
    return String.join(" and ", members) + (members.size() == 1 ? " says" : " say");
  }

  /** What was done with them follows. */
  public static String were(Collection<String> members) {
    return String.join(" and ", members) + (members.size() == 1 ? " was" : " were");
  }

  /** A member's own words, unless they speak of it by name already, inside a sentence. */
  public static String said(String member, String words) {
    return (words.startsWith(member + " ") ? "" : member + " says: ") + withoutFullStop(words);
  }

  public static String value(Expression expression) {
    return expression instanceof Expression.OfTerm ofTerm
        ? term(ofTerm.term())
        : SlPrinter.print(expression);
  }

  static String term(Term term) {
    if (term instanceof Term.Name name) {
      return Point.named(name.text())
          .map(point -> "(" + point.coordinates() + ")")
          .orElse(name.text());
    }
    if (term instanceof Term.Number number) {
      return number(number.value());
    }
    if (term instanceof Term.Text text) {
      return COORDINATES.matcher(text.value()).matches()
          ? "(" + text.value().replaceAll("(\\.\\d{2})\\d+", "$1") + ")"
          : SlPrinter.print(text);
    }
    return SlPrinter.print(term);
  }

  /** At most two decimals, three where there would be one digit else: for people. */
  public static String number(double value) {
    if (Math.abs(value) >= MOST_IN_FULL) {
      return String.valueOf(value);
    }
    String text = String.format(Locale.ROOT, Math.abs(value) < TENTH ? "%.3f" : "%.2f", value);
    return text.contains(".") ? text.replaceAll("0+$", "").replaceAll("\\.$", "") : text;
  }
}
