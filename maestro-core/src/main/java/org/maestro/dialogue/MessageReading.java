package org.maestro.dialogue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** What is to be done about a message that words mean: goals to state, or a question to put. */
final class MessageReading {
  private static final int MINUTES_OF_HOUR = 60;

  private MessageReading() {}

  /** The reading; empty when nothing can be done about it here. */
  static Optional<Reading> of(Content message, Home home) {
    return switch (message.operator()) {
      case "query-if" -> formula(message).map(MessageReading::question);
      case "query-ref" -> asked(message);
      case "seq" -> goals(message, home);
      default -> goal(message, home).map(goals -> new Reading.Goals(goals));
    };
  }

  private static Reading question(Formula formula) {
    return new Reading.Asked(SlPrinter.print(formula));
  }

  private static Optional<Formula> formula(Content message) {
    return message.arguments().stream()
        .filter(Content.Argument.OfFormula.class::isInstance)
        .map(one -> ((Content.Argument.OfFormula) one).formula())
        .findFirst();
  }

  private static Optional<Content.Argument.Named> named(Content message, String name) {
    return message.arguments().stream()
        .filter(Content.Argument.Named.class::isInstance)
        .map(Content.Argument.Named.class::cast)
        .filter(one -> one.name().equals(name))
        .findFirst();
  }

  private static Optional<Reading> asked(Content message) {
    Optional<Content.Argument.Named> value = named(message, "value");
    if (value.isPresent()) {
      return value.get().arguments().stream()
          .findFirst()
          .map(fluent -> new Reading.Asked("(= %s ?value)".formatted(SlPrinter.print(fluent))));
    }
    if (named(message, "history").isPresent()) {
      return Optional.empty();
    }
    Optional<String> formula = formula(message).map(SlPrinter::print);
    return named(message, "count").isPresent()
        ? formula.map(Reading.Counted::new)
        : formula.map(Reading.Asked::new);
  }

  private static Optional<Reading> goals(Content sequence, Home home) {
    List<String> all = new ArrayList<>();
    for (Content.Argument part : sequence.arguments()) {
      Optional<List<String>> goals =
          part instanceof Content.Argument.Nested nested
              ? goal(nested.content(), home)
              : Optional.empty();
      if (goals.isEmpty()) {
        return Optional.empty();
      }
      all.addAll(goals.get());
    }
    return Optional.of(new Reading.Goals(all));
  }

  /** The goals that the message states, one for each time that a script is to be run. */
  private static Optional<List<String>> goal(Content message, Home home) {
    return switch (message.operator()) {
      case "initCNP" ->
          named(message, "goal")
              .flatMap(goal -> goal.arguments().stream().findFirst())
              .map(formula -> List.of(SlPrinter.print(formula)));
      case "perform" -> script(message, home);
      case "whenever", "at", "after", "until" -> bound(message, home);
      default -> Optional.empty();
    };
  }

  private static Optional<List<String>> script(Content message, Home home) {
    Optional<Script> script =
        named(message, "script")
            .flatMap(one -> one.arguments().stream().findFirst())
            .map(SlPrinter::print)
            .map(home.scripts()::get);
    if (script.isEmpty()) {
      return Optional.empty();
    }
    List<String> calls = new ArrayList<>(List.of("(" + script.get().name()));
    for (var parameter : script.get().parameters()) {
      Optional<Content.Argument.Named> said = named(message, parameter.name());
      if (said.isEmpty() || said.get().arguments().isEmpty()) {
        return Optional.empty();
      }
      List<String> longer = new ArrayList<>();
      for (String call : calls) {
        said.get().arguments().forEach(value -> longer.add(call + " " + SlPrinter.print(value)));
      }
      calls = longer;
    }
    return Optional.of(calls.stream().map(call -> call + ")").toList());
  }

  /** Goals that begin or end at a time or an event. */
  private static Optional<List<String>> bound(Content message, Home home) {
    Optional<List<String>> inner =
        message.arguments().stream()
            .filter(Content.Argument.Nested.class::isInstance)
            .map(one -> ((Content.Argument.Nested) one).content())
            .findFirst()
            .flatMap(content -> goal(content, home));
    Optional<String> occasion = occasion(message);
    if (inner.isEmpty() || occasion.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        inner.get().stream()
            .map(goal -> "(%s %s %s)".formatted(message.operator(), occasion.get(), goal))
            .toList());
  }

  private static Optional<String> occasion(Content message) {
    Optional<Formula> event = formula(message);
    if (event.isPresent()) {
      return event.map(SlPrinter::print);
    }
    Optional<Double> number =
        number(message.arguments())
            .or(() -> named(message, "at").flatMap(one -> number(one.arguments())))
            .or(() -> named(message, "after").flatMap(one -> number(one.arguments())));
    boolean isSpan = message.operator().equals("after") || named(message, "after").isPresent();
    String every =
        named(message, "every")
            .map(
                days ->
                    days.arguments().stream()
                        .map(SlPrinter::print)
                        .collect(Collectors.joining(" ", " :every \"", "\"")))
            .orElse("");
    return number.map(
        value -> isSpan ? SlPrinter.print(value) : "\"" + clock(value) + "\"" + every);
  }

  private static Optional<Double> number(List<Content.Argument> arguments) {
    return arguments.stream()
        .filter(Content.Argument.OfTerm.class::isInstance)
        .map(one -> ((Content.Argument.OfTerm) one).term())
        .filter(Term.Number.class::isInstance)
        .map(one -> ((Term.Number) one).value())
        .findFirst();
  }

  private static String clock(double minutes) {
    int all = (int) minutes;
    return String.format(Locale.ROOT, "%02d:%02d", all / MINUTES_OF_HOUR, all % MINUTES_OF_HOUR);
  }
}
