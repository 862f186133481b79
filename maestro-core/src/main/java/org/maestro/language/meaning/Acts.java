package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Pattern;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** What an utterance's reading means. Bound to one reading in one situation. */
final class Acts {
  private static final String SELF = "self";
  private static final String SPEAKER = "speaker";
  private static final double SECONDS_IN_MINUTE = 60;
  private static final int MINUTES_IN_DAY = 1440;

  private final Situation situation;
  private final References references;
  private final Set<String> idle;
  private final Measures measures;
  private final States states;
  private final Frames frames;
  private final Questions questions;

  Acts(Situation situation, References references, Set<String> idle) {
    this.situation = situation;
    this.references = references;
    this.idle = idle;
    this.measures = new Measures(situation, references, idle);
    this.states = new States(situation, references);
    this.frames = new Frames(situation, references, states, this::condition);
    this.questions = new Questions(situation, references, states, measures, this);
  }

  static Acts in(Situation situation, NounPhrases phrases, Settables settables, Set<String> idle) {
    return new Acts(situation, new References(phrases, settables), idle);
  }

  References references() {
    return references;
  }

  Frames frames() {
    return frames;
  }

  /** {@code (initCNP (:goal formula))}. */
  static Content goal(Formula formula) {
    return new Content(
        "initCNP",
        List.of(
            new Content.Argument.Named("goal", List.of(new Content.Argument.OfFormula(formula)))));
  }

  /** The message of an act. */
  Optional<Content> message(Form act) {
    return switch (act.head()) {
      case "do" -> {
        references.wishing();
        yield command(act.part(0));
      }
      case "instead", "yes" -> act.parts().isEmpty() ? Optional.empty() : message(act.part(0));
      case "wish" -> wish(act);
      case "refrain" -> refrain(act.part(0));
      case "whenever", "if" -> whenever(act.part(0), act.part(1), act.is("if"));
      case "act-whenever", "act-if" -> actWhenever(act.part(0), act.part(1), act.is("act-if"));
      case "timed" -> timed(act.part(0), act.part(1));
      case "act-timed" -> timed(act.part(1), act.part(0));
      case "tell" -> tell(act.part(0));
      case "nevermind" -> Optional.of(cancel("question"));
      case "cancel" -> Optional.of(cancel("last"));
      case "undo" -> Optional.of(cancel("undo"));
      default -> questions.message(act);
    };
  }

  private static Content cancel(String what) {
    return new Content("cancel", List.of(new Content.Argument.Named(what, List.of())));
  }

  private Optional<Content> wish(Form act) {
    Optional<List<Term>> who = references.terms(act.part(0), "");
    if (who.isEmpty() || who.get().size() != 1 || !(who.get().get(0) instanceof Term.Name name)) {
      references.die();
      return Optional.empty();
    }
    return new Acts(situation.spokenBy(name.text()), references, idle)
        .command(withOwn(act.part(1), name));
  }

  /** What somebody wishes as his is his own, and what for him is for himself. */
  private static Form withOwn(Form said, Term.Name wishing) {
    if (said.is("of") && said.part(0).is("him")) {
      return Form.of("of", Form.leaf("speaker"), withOwn(said.part(1), wishing));
    }
    if (said.is("him")) {
      return Form.of("np", Form.leaf("the"), Form.of("name", Form.leaf(wishing.text())));
    }
    return new Form(
        said.head(), said.parts().stream().map(part -> withOwn(part, wishing)).toList());
  }

  /** The message of a command. */
  Optional<Content> command(Form verb) {
    return switch (verb.head()) {
      case "frame" -> frames.message(verb);
      case "both" -> both(verb);
      case "query" -> questions.message(verb.part(0));
      case "excepting" -> command(excepting(verb.part(0), verb.part(1)));
      case "located" -> command(located(verb.part(0), verb.part(1)));
      case "run" -> Optional.of(run(verb.part(0)));
      case "benefiting" -> benefiting(verb.part(0), verb.part(1));
      case "later" -> timed(verb.part(0), Form.of("do", verb.part(1)));
      case "keep" ->
          states.bringing(verb.part(0), verb.part(1)).map(Formula.Keep::new).map(Acts::goal);
      case "keepcompared" -> bounded(verb).map(Formula.Keep::new).map(Acts::goal);
      case "hold" ->
          measures.assigned(verb.part(0), verb.part(1)).map(Formula.Keep::new).map(Acts::goal);
      default -> formula(verb).map(Acts::goal);
    };
  }

  /** For whom something is done that is done for nobody is only said. */
  private Optional<Content> benefiting(Form verb, Form who) {
    Optional<List<Term>> persons =
        NounPhrases.persons(situation.home()).flatMap(kind -> references.terms(who, kind));
    if (persons.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return command(verb);
  }

  /** A place that is said at the end is that of the first thing that was said. */
  private Form located(Form verb, Form where) {
    List<Form> parts = new ArrayList<>(verb.parts());
    Optional<Construction> construction =
        verb.is("frame") ? Optional.of(frames.construction(verb)) : Optional.empty();
    for (int i = 0; i < parts.size(); i++) {
      Form part = parts.get(i);
      if (part.is("role") && !mayBeSomewhere(construction, part.text(0))) {
        continue;
      }
      Form placed =
          part.is("role")
              ? Form.of("role", part.part(0), NounPhrases.placed(part.part(1), where))
              : part.is("measure") ? Measures.placed(part, where) : NounPhrases.placed(part, where);
      if (!placed.equals(part)) {
        parts.set(i, placed);
        return new Form(verb.head(), parts);
      }
    }
    return construction
        .flatMap(one -> withUnsaid(one, verb, where))
        .orElseGet(() -> Form.of("nowhere"));
  }

  /** What is left out at the end is left out of the first thing that was said. */
  private static Form excepting(Form verb, Form but) {
    List<Form> parts = new ArrayList<>(verb.parts());
    for (int i = 0; i < parts.size(); i++) {
      Form part = parts.get(i);
      if (part.is("np") || part.is("everything")) {
        parts.set(i, Form.of("except", part, but));
        return new Form(verb.head(), parts);
      } else if (verb.is("located") && i == 0) {
        Form left = excepting(part, but);
        return left.is("nowhere") ? left : Form.of("located", left, verb.part(1));
      } else if (part.is("role") && part.part(1).is("np")) {
        parts.set(i, Form.of("role", part.part(0), Form.of("except", part.part(1), but)));
        return new Form(verb.head(), parts);
      }
    }
    return Form.of("nowhere");
  }

  private boolean mayBeSomewhere(Optional<Construction> construction, String role) {
    return construction.stream()
        .flatMap(one -> one.roles().stream())
        .filter(one -> one.name().equals(role))
        .allMatch(one -> references.phrases().relations().mayBeSomewhere(one.type()));
  }

  /** What is played is nowhere; what plays it is there. */
  private Optional<Form> withUnsaid(Construction construction, Form verb, Form where) {
    return construction.roles().stream()
        .filter(role -> situation.home().vocabulary().classes().containsKey(role.type()))
        .filter(role -> mayBeSomewhere(Optional.of(construction), role.name()))
        .filter(role -> !isUsuallyWhoSpeaks(role))
        .filter(
            role ->
                verb.parts().stream()
                    .noneMatch(part -> part.is("role") && part.text(0).equals(role.name())))
        .findFirst()
        .map(
            role -> {
              List<Form> parts = new ArrayList<>(verb.parts());
              Form kind = Form.of("noun", Form.leaf(role.type()));
              parts.add(
                  Form.of(
                      "role",
                      Form.leaf(role.name()),
                      Form.of(
                          "np",
                          Form.leaf(where.is("everywhere") ? "all" : "the"),
                          Form.of("at", kind, where))));
              return new Form(verb.head(), parts);
            });
  }

  /** Who says hello in the kitchen greets nobody else who is there. */
  private static boolean isUsuallyWhoSpeaks(Construction.Role role) {
    return role.usually().filter(new Term.Variable(SPEAKER)::equals).isPresent();
  }

  private Optional<Formula> formula(Form verb) {
    return switch (verb.head()) {
      case "assign" -> measures.assigned(verb.part(0), verb.part(1));
      case "raise" -> measures.changed(verb.part(0), verb.part(1), 1);
      case "lower" -> measures.changed(verb.part(0), verb.part(1), -1);
      case "more" -> measures.more(verb.part(0), 1);
      case "less" -> measures.more(verb.part(0), -1);
      case "become" -> states.bringing(verb.part(0), verb.part(1));
      case "ensure" -> ensured(verb.part(0));
      case "compares" -> bounded(verb);
      default -> {
        references.die();
        yield Optional.empty();
      }
    };
  }

  private Optional<Formula> ensured(Form clause) {
    Form state = clause.part(1);
    return state.is("rel") || state.is("here")
        ? states.at(clause.part(0), state)
        : states.bringing(clause.part(0), state);
  }

  private static Content run(Form script) {
    return new Content(
        "perform",
        List.of(
            new Content.Argument.Named(
                "script", List.of(new Content.Argument.OfTerm(new Term.Name(script.text(0)))))));
  }

  /** What is done at the same time is one goal; what comes after the other is a sequence. */
  private Optional<Content> both(Form verb) {
    List<Form> verbs = new ArrayList<>();
    flatten(verb, verbs);
    List<Content> messages = new ArrayList<>();
    for (Form one : verbs) {
      Optional<Content> message = command(one);
      if (message.isEmpty()) {
        return message;
      }
      messages.add(message.get());
    }
    for (int i = 0; i < verbs.size(); i++) {
      if (isOpen(messages.get(i))) {
        // What one leaves open another may have named.
        messages.set(i, command(verbs.get(i)).orElse(messages.get(i)));
      }
    }
    List<Content> parts = new ArrayList<>();
    messages.forEach(message -> join(parts, message));
    return Optional.of(
        parts.size() == 1
            ? parts.get(0)
            : new Content(
                "seq",
                parts.stream().<Content.Argument>map(Content.Argument.Nested::new).toList()));
  }

  private static void flatten(Form verb, List<Form> verbs) {
    if (verb.is("both")) {
      verb.parts().forEach(part -> flatten(part, verbs));
    } else {
      verbs.add(verb);
    }
  }

  private void join(List<Content> parts, Content next) {
    int last = parts.size() - 1;
    Optional<Formula> before =
        parts.isEmpty() || isOnTheWay(parts.get(last)) ? Optional.empty() : goalOf(parts.get(last));
    Optional<Formula> after = goalOf(next);
    if (before.isPresent() && after.isPresent()) {
      parts.set(last, goal(References.conjunction(List.of(before.get(), after.get()))));
    } else {
      parts.add(next);
    }
  }

  /** Where the robot is, and what it holds, is only on the way to what it does next. */
  private boolean isOnTheWay(Content content) {
    String said = SlPrinter.print(content);
    return goalOf(content).filter(goal -> FreeVariables.of(goal).contains(SELF)).isPresent()
        || situation
            .self()
            .filter(
                robot ->
                    Pattern.compile("[ (]" + Pattern.quote(robot) + "[ )]").matcher(said).find())
            .isPresent();
  }

  private static boolean isOpen(Content content) {
    return goalOf(content).filter(goal -> !FreeVariables.of(goal).isEmpty()).isPresent();
  }

  /** The formula of a message that states a goal. */
  static Optional<Formula> goalOf(Content content) {
    if (content.operator().equals("initCNP")
        && content.arguments().size() == 1
        && content.arguments().get(0) instanceof Content.Argument.Named named
        && named.arguments().size() == 1
        && named.arguments().get(0) instanceof Content.Argument.OfFormula ofFormula) {
      return Optional.of(ofFormula.formula());
    }
    return Optional.empty();
  }

  private Optional<Content> refrain(Form verb) {
    return command(verb)
        .flatMap(Acts::goalOf)
        .map(
            formula ->
                new Content(
                    "cancel",
                    List.of(
                        new Content.Argument.Named(
                            "goal", List.of(new Content.Argument.OfFormula(formula))))));
  }

  private Optional<Content> whenever(Form condition, Form act, boolean isNow) {
    Optional<Formula> when = condition(condition);
    return whenever(when, message(act), isNow);
  }

  /** What is said first is what may be spoken of later. */
  private Optional<Content> actWhenever(Form act, Form condition, boolean isNow) {
    Optional<Content> then = message(act);
    return whenever(condition(condition), then, isNow);
  }

  /**
   * @param isNow whether it may be asked of what is so now, rather than each time
   */
  private static Optional<Content> whenever(
      Optional<Formula> when, Optional<Content> then, boolean isNow) {
    if (when.isEmpty() || then.isEmpty()) {
      return Optional.empty();
    }
    if (isNow && goalOf(then.get()).filter(goal -> isOppositeOf(when.get(), goal)).isPresent()) {
      // Who has the light turned off if it is on has no rule that nobody may ever turn it on.
      return then;
    }
    return Optional.of(
        new Content(
            "whenever",
            List.of(
                new Content.Argument.OfFormula(when.get()),
                new Content.Argument.Nested(then.get()))));
  }

  /** Whether a condition says no more than that the goal is not reached yet. */
  private static boolean isOppositeOf(Formula condition, Formula goal) {
    return condition.equals(new Formula.Not(goal))
        || goal.equals(new Formula.Not(condition))
        || condition instanceof Formula.Comparison some
            && goal instanceof Formula.Comparison none
            && some.relation() == Formula.Relation.GREATER
            && none.relation() == Formula.Relation.EQUAL
            && some.left().equals(none.left())
            && some.right().equals(none.right());
  }

  /** What is so when a condition holds. */
  Optional<Formula> condition(Form condition) {
    switch (condition.head()) {
      case "be":
        return states.holding(condition.part(0), condition.part(1));
      case "happens":
        return frames.holding(condition.part(0));
      case "there":
        return there(condition.part(0));
      case "compares":
        return measures.compared(condition.part(0), relation(condition.part(1)), condition.part(2));
      default:
        references.die();
        return Optional.empty();
    }
  }

  private Optional<Formula> bounded(Form said) {
    return measures.bounded(said.part(0), relation(said.part(1)), said.part(2));
  }

  private static Formula.Relation relation(Form said) {
    return switch (said.head()) {
      case "over", "more" -> Formula.Relation.GREATER;
      case "least" -> Formula.Relation.AT_LEAST;
      case "most" -> Formula.Relation.AT_MOST;
      default -> Formula.Relation.LESS;
    };
  }

  /** That there is something of which more is said than its kind. */
  private Optional<Formula> there(Form phrase) {
    if (references.phrases().resolve(phrase, "") instanceof Reference.Any any
        && !any.conditions().isEmpty()) {
      return Optional.of(
          new Formula.Exists(List.of(any.variable()), References.conjunction(any.conditions())));
    }
    references.die();
    return Optional.empty();
  }

  private Optional<Content> timed(Form when, Form act) {
    Optional<Form> frame = Frames.within(act);
    Optional<Form> said = frame.flatMap(frames::clock);
    if (said.isPresent() && isADay(when)) {
      return onDay(when, said.get(), act);
    }
    if (isOfTheClock(when) && isTimedByTheClock(act)) {
      // Nothing begins at two times of the day.
      references.die();
      return Optional.empty();
    }
    Optional<Content> then = message(act);
    if (then.isEmpty()) {
      return then;
    }
    Content.Argument nested = new Content.Argument.Nested(then.get());
    switch (when.head()) {
      case "at":
        return clock(when.part(0), frame).map(minute -> new Content("at", List.of(minute, nested)));
      case "every", "on":
        return onDays(when, nested);
      case "after":
        return Optional.of(new Content("after", List.of(seconds(when.part(0)), nested)));
      case "tomorrow":
        return tomorrow(when.part(0), nested);
      case "until":
        return clock(when.part(0), Optional.empty())
            .map(
                minute ->
                    new Content(
                        "until",
                        List.of(new Content.Argument.Named("at", List.of(minute)), nested)));
      case "untilafter":
        return Optional.of(
            new Content(
                "until",
                List.of(
                    new Content.Argument.Named("after", List.of(seconds(when.part(0)))), nested)));
      case "untilthat":
        return condition(when.part(0))
            .map(
                formula ->
                    new Content("until", List.of(new Content.Argument.OfFormula(formula), nested)));
      default:
        references.die();
        return Optional.empty();
    }
  }

  private static boolean isTimedByTheClock(Form act) {
    return act.is("timed") && isOfTheClock(act.part(0))
        || act.is("act-timed") && isOfTheClock(act.part(1));
  }

  private static boolean isOfTheClock(Form when) {
    return when.is("at") || when.is("every") || when.is("on") || when.is("tomorrow");
  }

  /** Of two times that are called the same that of the morning is meant, whenever it is said. */
  private Optional<Content> onDays(Form when, Content.Argument nested) {
    OptionalInt minute = Values.minuteOfTomorrow(when.part(1));
    if (minute.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return Optional.of(
        new Content(
            "at",
            List.of(
                new Content.Argument.OfTerm(new Term.Number(minute.getAsInt())),
                new Content.Argument.Named(when.head(), names(when.part(0))),
                nested)));
  }

  /** One, or all of several. */
  private static List<Content.Argument> names(Form days) {
    return (days.parts().isEmpty() ? List.of(days) : days.parts())
        .stream()
            .<Content.Argument>map(day -> new Content.Argument.OfTerm(new Term.Name(day.head())))
            .toList();
  }

  /** A time of the next day is so long after now. */
  private Optional<Content> tomorrow(Form clock, Content.Argument nested) {
    if (clock.is("_")) {
      // Nobody has said when.
      references.die();
      return Optional.empty();
    }
    OptionalInt minute = Values.minuteOfTomorrow(clock);
    if (minute.isEmpty() || situation.minuteOfDay().isEmpty()) {
      references.die();
      return Optional.empty();
    }
    double seconds =
        SECONDS_IN_MINUTE
            * (MINUTES_IN_DAY - situation.minuteOfDay().getAsInt() + minute.getAsInt());
    return Optional.of(
        new Content(
            "after", List.of(new Content.Argument.OfTerm(new Term.Number(seconds)), nested)));
  }

  private static Content.Argument seconds(Form span) {
    return new Content.Argument.OfTerm(new Term.Number(Values.seconds(span)));
  }

  /** Whether it says on which day something is, or in which part of it, and not when. */
  private static boolean isADay(Form when) {
    return when.is("tomorrow") && (when.part(0).is("_") || isAPart(when.part(0)))
        || when.is("at") && isAPart(when.part(0));
  }

  private static boolean isAPart(Form clock) {
    return clock.is("part") && clock.parts().size() == 1;
  }

  /** A day that is said beside the time which is set is the day of that time. */
  private Optional<Content> onDay(Form when, Form clock, Form act) {
    Form day = when.part(0);
    Form exact =
        day.is("_")
            ? Form.of("part", Form.leaf("any"), clock)
            : Form.of("part", day.part(0), clock);
    Optional<Content> then = message(replaced(act, clock, exact));
    OptionalInt minute = Values.minuteOfTomorrow(exact);
    if (then.isEmpty() || when.is("at")) {
      return then;
    }
    if (minute.isEmpty() || situation.minuteOfDay().isEmpty()) {
      references.die();
      return Optional.empty();
    }
    int now = situation.minuteOfDay().getAsInt();
    if (minute.getAsInt() <= now) {
      return then;
    }
    // Who sets a clock to a time that is still to come today sets it for today.
    double untilMidnight = SECONDS_IN_MINUTE * (MINUTES_IN_DAY - now);
    return Optional.of(
        new Content(
            "after",
            List.of(
                new Content.Argument.OfTerm(new Term.Number(untilMidnight)),
                new Content.Argument.Nested(then.get()))));
  }

  private static Form replaced(Form form, Form part, Form by) {
    return form.equals(part)
        ? by
        : new Form(form.head(), form.parts().stream().map(one -> replaced(one, part, by)).toList());
  }

  /**
   * @param frame of what is done then
   */
  private Optional<Content.Argument> clock(Form clock, Optional<Form> frame) {
    boolean isOfTheMorning =
        frame.filter(one -> frames.construction(one).inTheMorning()).isPresent();
    OptionalInt minute =
        isOfTheMorning
            ? Values.minuteOfMorning(clock, situation.minuteOfDay())
            : Values.minuteOfDay(clock, situation.minuteOfDay());
    if (minute.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return Optional.of(new Content.Argument.OfTerm(new Term.Number(minute.getAsInt())));
  }

  private Optional<Content> tell(Form clause) {
    if (clause.is("frame") && frames.construction(clause).means().isPresent()) {
      references.wishing();
      return frames.message(clause);
    }
    boolean isOfNobody =
        clause.parts().stream().anyMatch(part -> part.is("somebody") || part.is("nobody"));
    if (clause.is("be") && isOfNobody) {
      references.die();
      return Optional.empty();
    }
    Optional<Formula> said =
        clause.is("be") ? states.holding(clause.part(0), clause.part(1)) : frames.holding(clause);
    return said.map(
        formula ->
            new Content(
                "inform",
                List.of(
                    new Content.Argument.Named(
                        "facts",
                        List.of(
                            new Content.Argument.OfTerm(
                                new Term.Text(SlPrinter.print(formula))))))));
  }
}
