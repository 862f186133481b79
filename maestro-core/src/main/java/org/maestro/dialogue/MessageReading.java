package org.maestro.dialogue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.wording.FactWords;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** What is to be done about a message that words mean: goals to state, or a question to put. */
final class MessageReading {
  private static final int MINUTES_OF_HOUR = 60;
  private static final String TEXT = "string";

  private final Home home;
  private final Grammar grammar;

  /**
   * @param grammar in whose words is told what a formula says, where a text is wanted
   */
  MessageReading(Home home, Grammar grammar) {
    this.home = home;
    this.grammar = grammar;
  }

  /** The reading; empty when nothing can be done about it here. */
  Optional<Reading> of(Content message) {
    return switch (message.operator()) {
      case "query-if" ->
          formula(message)
              .map(MessageReading::question)
              .or(() -> about(message, "done", Reading.About.What.WHETHER_DONE));
      case "explain" -> Optional.of(new Reading.About(Reading.About.What.WHY, goal(message)));
      case "cancel" -> calledOff(message);
      case "query-ref" -> asked(message);
      case "seq" -> goals(message);
      default ->
          named(message, "last").isPresent()
              ? Optional.of(new Reading.Again())
              : stated(message).map(goals -> new Reading.Goals(goals));
    };
  }

  /** What was asked for last, or what is named. */
  private static Optional<Reading> calledOff(Content message) {
    return named(message, "undo").isPresent()
        ? Optional.of(new Reading.Undone())
        : Optional.of(new Reading.CalledOff(goal(message)));
  }

  /** The formula of a goal that is spoken of. */
  private static Optional<Formula> goal(Content message) {
    return named(message, "goal")
        .flatMap(goal -> goal.arguments().stream().findFirst())
        .filter(Content.Argument.OfFormula.class::isInstance)
        .map(formula -> ((Content.Argument.OfFormula) formula).formula());
  }

  private static Optional<Reading> about(Content message, String name, Reading.About.What what) {
    return named(message, name).map(one -> new Reading.About(what, Optional.empty()));
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

  private Optional<Reading> asked(Content message) {
    Optional<Content.Argument.Named> able = named(message, "able");
    if (able.isPresent()) {
      return Optional.of(
          new Reading.Able(able.get().arguments().stream().findFirst().map(MessageReading::term)));
    }
    Optional<Content.Argument.Named> history = named(message, "history");
    if (history.isPresent()) {
      return Optional.of(new Reading.About(Reading.About.What.WHO, past(history.get())));
    }
    return about(message, "doing", Reading.About.What.DOING)
        .or(() -> about(message, "done", Reading.About.What.DONE))
        .or(() -> about(message, "planned", Reading.About.What.PLANNED))
        .or(() -> about(message, "asked", Reading.About.What.ASKED))
        .or(() -> about(message, "lasts", Reading.About.What.LASTS))
        .or(() -> known(message));
  }

  private static Term term(Content.Argument argument) {
    return argument instanceof Content.Argument.OfTerm of
        ? of.term()
        : new Term.Text(SlPrinter.print(argument));
  }

  /** What has become so, as it stands in a text. */
  private Optional<Formula> past(Content.Argument.Named history) {
    return history.arguments().stream()
        .findFirst()
        .map(MessageReading::term)
        .filter(Term.Text.class::isInstance)
        .flatMap(text -> read(((Term.Text) text).value()));
  }

  private Optional<Formula> read(String text) {
    try {
      return Optional.of(SlParser.formula(text, home.vocabulary()::isFluent));
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }

  private static Optional<Reading> known(Content message) {
    Optional<Content.Argument.Named> value = named(message, "value");
    if (value.isPresent()) {
      return value.get().arguments().stream()
          .findFirst()
          .map(fluent -> new Reading.Asked("(= %s ?value)".formatted(SlPrinter.print(fluent))));
    }
    Optional<String> formula = formula(message).map(SlPrinter::print);
    return named(message, "count").isPresent()
        ? formula.map(Reading.Counted::new)
        : formula.map(Reading.Asked::new);
  }

  private Optional<Reading> goals(Content sequence) {
    List<String> all = new ArrayList<>();
    for (Content.Argument part : sequence.arguments()) {
      Optional<List<String>> goals =
          part instanceof Content.Argument.Nested nested
              ? stated(nested.content())
              : Optional.empty();
      if (goals.isEmpty()) {
        return Optional.empty();
      }
      all.addAll(goals.get());
    }
    return Optional.of(new Reading.Goals(all));
  }

  /** The goals that the message states, one for each time that a script is to be run. */
  private Optional<List<String>> stated(Content message) {
    return switch (message.operator()) {
      case "initCNP" ->
          named(message, "goal")
              .flatMap(goal -> goal.arguments().stream().findFirst())
              .map(formula -> List.of(SlPrinter.print(formula)));
      case "perform" -> script(message);
      case "whenever", "once", "at", "after", "until" -> bound(message);
      default -> Optional.empty();
    };
  }

  private Optional<List<String>> script(Content message) {
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
      boolean isText = parameter.className().filter(TEXT::equals).isPresent();
      for (String call : calls) {
        said.get()
            .arguments()
            .forEach(value -> longer.add(call + " " + (isText ? text(value) : print(value))));
      }
      calls = longer;
    }
    return Optional.of(calls.stream().map(call -> call + ")").toList());
  }

  private static String print(Content.Argument value) {
    return SlPrinter.print(value);
  }

  /** What a formula says, where it stands for a text: to whoever hears it then. */
  private String text(Content.Argument value) {
    if (!(value instanceof Content.Argument.OfFormula of)) {
      return print(value);
    }
    Optional<String> sentence =
        new FactWords(home, grammar, Optional.empty()).sentence(of.formula());
    return SlPrinter.print(new Term.Text(sentence.orElseGet(() -> print(value))));
  }

  /** Goals that begin or end at a time or an event. */
  private Optional<List<String>> bound(Content message) {
    Optional<List<String>> inner =
        message.arguments().stream()
            .filter(Content.Argument.Nested.class::isInstance)
            .map(one -> ((Content.Argument.Nested) one).content())
            .findFirst()
            .flatMap(this::stated);
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
    String days = days(message, "every") + days(message, "on");
    return number.map(value -> isSpan ? SlPrinter.print(value) : "\"" + clock(value) + "\"" + days);
  }

  private static String days(Content message, String word) {
    return named(message, word)
        .map(
            days ->
                days.arguments().stream()
                    .map(SlPrinter::print)
                    .collect(Collectors.joining(" ", " :" + word + " \"", "\"")))
        .orElse("");
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
