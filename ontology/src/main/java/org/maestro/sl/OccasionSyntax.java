package org.maestro.sl;

import java.time.DateTimeException;
import java.time.DayOfWeek;
import java.time.LocalDate;
import java.time.LocalTime;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Goals that are bound to a time or an event. Their words may name predicates all the same: {@code
 * (at rose zone-a)} is an atom, since it has neither a text, a number nor a list after the word.
 */
final class OccasionSyntax {
  private static final String AT = "at";
  private static final String AFTER = "after";
  private static final String UNTIL = "until";
  private static final String WHENEVER = "whenever";
  private static final String ONCE = "once";
  private static final Set<String> WORDS = Set.of(AT, AFTER, UNTIL, WHENEVER, ONCE);

  private static final String A_TIME =
      "a time in quotes, such as \"22:30\" or \"2026-12-24 18:00\"";
  private static final String SECONDS = "seconds, a number from 0 to 1000000000";
  private static final String DAYS =
      "\"day\", or days of the week in quotes, such as \"Monday Friday\"";
  private static final String DAYS_ALONE = "days of the week in quotes, such as \"Friday\"";
  private static final String A_GOAL = "a goal";
  private static final double MOST_SECONDS = 1e9;

  private static final Pattern TIME =
      Pattern.compile("(?:(\\d{4}-\\d\\d-\\d\\d) )?(\\d\\d:\\d\\d(?::\\d\\d)?)");
  private static final String EACH_DAY = "day";
  private static final String EVERY = "every";
  private static final String ON = "on";

  private final Function<Node, Formula> formulas;
  private final Function<Node, Formula> goals;

  /**
   * @param formulas reads conditions
   * @param goals reads what is bound
   */
  OccasionSyntax(Function<Node, Formula> formulas, Function<Node, Formula> goals) {
    this.formulas = formulas;
    this.goals = goals;
  }

  static boolean begins(Node.Group group) {
    return WORDS.contains(group.head())
        && (group.rest().stream().anyMatch(Node.Group.class::isInstance)
            || group.rest().stream().findFirst().filter(OccasionSyntax::isWritten).isPresent());
  }

  private static boolean isWritten(Node node) {
    return isLeaf(node, Node.Kind.STRING) || isLeaf(node, Node.Kind.NUMBER);
  }

  private static boolean isLeaf(Node node, Node.Kind kind) {
    return node instanceof Node.Leaf leaf && leaf.kind() == kind;
  }

  Formula bound(Node.Group group) {
    List<Node> rest = group.rest();
    return switch (group.head()) {
      case AT -> {
        boolean hasDays = rest.size() > 1 && isLeaf(rest.get(1), Node.Kind.KEYWORD);
        group.expectOperands(hasDays ? 4 : 2, A_TIME + ", and a goal");
        yield new Formula.Upon(
            hasDays ? onDays(rest) : time(rest.get(0)), goals.apply(rest.get(hasDays ? 3 : 1)));
      }
      case AFTER -> {
        group.expectOperands(2, SECONDS + ", and a goal");
        yield new Formula.Upon(seconds(rest.get(0)), goals.apply(rest.get(1)));
      }
      case WHENEVER, ONCE -> {
        group.expectOperands(2, "a condition and a goal");
        yield new Formula.Upon(
            new Occasion.Event(formulas.apply(rest.get(0)), group.head().equals(WHENEVER)),
            goals.apply(rest.get(1)));
      }
      default -> {
        group.expectOperands(2, "a time, seconds or a condition, and " + A_GOAL);
        yield new Formula.Until(end(rest.get(0)), goals.apply(rest.get(1)));
      }
    };
  }

  private Occasion end(Node node) {
    if (node instanceof Node.Group) {
      return new Occasion.Event(formulas.apply(node), false);
    }
    return isLeaf(node, Node.Kind.NUMBER) ? seconds(node) : time(node);
  }

  private static Occasion.At time(Node node) {
    if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.STRING) {
      Matcher written = TIME.matcher(leaf.text());
      if (written.matches()) {
        try {
          return Occasion.At.once(
              Optional.ofNullable(written.group(1)).map(LocalDate::parse),
              LocalTime.parse(written.group(2)));
        } catch (DateTimeException e) {
          throw node.fault(A_TIME);
        }
      }
    }
    throw node.fault(A_TIME);
  }

  private static Occasion.At onDays(List<Node> rest) {
    Occasion.At first = time(rest.get(0));
    String word = ((Node.Leaf) rest.get(1)).text();
    boolean again = word.equals(EVERY);
    if (!again && !word.equals(ON)) {
      throw rest.get(1).fault(":every, :on or a goal");
    }
    if (first.date().isPresent()) {
      throw rest.get(0).fault("a time without a date before :every and :on");
    }
    Set<DayOfWeek> days = again ? days(rest.get(2)) : daysOfTheWeek(rest.get(2), DAYS_ALONE);
    return new Occasion.At(Optional.empty(), first.time(), days, again);
  }

  private static Set<DayOfWeek> days(Node node) {
    return isLeaf(node, Node.Kind.STRING) && ((Node.Leaf) node).text().equals(EACH_DAY)
        ? EnumSet.allOf(DayOfWeek.class)
        : daysOfTheWeek(node, DAYS);
  }

  private static Set<DayOfWeek> daysOfTheWeek(Node node, String expected) {
    if (!(node instanceof Node.Leaf leaf) || leaf.kind() != Node.Kind.STRING) {
      throw node.fault(expected);
    }
    Set<DayOfWeek> days = EnumSet.noneOf(DayOfWeek.class);
    for (String word : leaf.text().split("[ ,]+")) {
      days.add(
          List.of(DayOfWeek.values()).stream()
              .filter(day -> day.name().equalsIgnoreCase(word))
              .findFirst()
              .orElseThrow(() -> node.fault(expected)));
    }
    return days;
  }

  private static Occasion seconds(Node node) {
    if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.NUMBER) {
      double seconds = Double.parseDouble(leaf.text());
      if (seconds >= 0 && seconds <= MOST_SECONDS) {
        return new Occasion.After(seconds);
      }
    }
    throw node.fault(SECONDS);
  }

  /** The word, and the occasion as it is written after it. */
  static String begin(Formula.Bound bound) {
    Occasion occasion = bound.occasion();
    if (occasion instanceof Occasion.At at) {
      String time = at.date().map(date -> date + " ").orElse("") + at.time();
      return "(%s \"%s\"%s".formatted(bound instanceof Formula.Until ? UNTIL : AT, time, days(at));
    } else if (occasion instanceof Occasion.After after) {
      return "(%s %s"
          .formatted(
              bound instanceof Formula.Until ? UNTIL : AFTER, SlPrinter.print(after.seconds()));
    }
    Occasion.Event event = (Occasion.Event) occasion;
    return "(%s %s"
        .formatted(
            bound instanceof Formula.Until ? UNTIL : event.again() ? WHENEVER : ONCE,
            SlPrinter.print(event.condition()));
  }

  private static String days(Occasion.At at) {
    if (at.days().isEmpty()) {
      return "";
    }
    String words =
        at.again() && at.days().size() == DayOfWeek.values().length
            ? EACH_DAY
            : String.join(" ", at.days().stream().map(OccasionSyntax::name).toList());
    return " :%s \"%s\"".formatted(at.again() ? EVERY : ON, words);
  }

  private static String name(DayOfWeek day) {
    return day.name().charAt(0) + day.name().substring(1).toLowerCase(Locale.ROOT);
  }
}
