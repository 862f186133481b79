package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.sl.Content;

/**
 * The messages by which several managers of goals share the components of a member (ADE, 6; A94).
 * An order is refused by {@code (inform (:held-by CCA) (:held-for G3) ...)}; who wants what another
 * has says {@code (want (:member rose) (:goal keeper-1) (:components arm base) ...)}, the holder is
 * told {@code (yield ...)} in the same words, answers {@code (give-back (:member rose) (:components
 * arm base))}, and the other one hears {@code (inform (:member rose) (:got arm base))}.
 */
public final class ArbitrationWords {

  /** How a holder is asked. */
  public static final String YIELD_EXAMPLE =
      "(yield (:member rose) (:goal G3) (:components arm base)).";

  private ArbitrationWords() {}

  /** An order is refused for now. */
  public static Content held(HeldElsewhere by, String member) {
    return Words.content(
        "inform",
        Words.named("outcome", Words.name("rejected")),
        Words.named("begun", Words.name("false")),
        Words.named("held-by", Words.name(by.manager())),
        Words.named("held-for", Words.name(by.goalId())),
        Words.named(
            "problem",
            Words.text(
                "%s has what it needs of %s, for %s"
                    .formatted(by.manager(), member, by.goalId()))));
  }

  public static Optional<HeldElsewhere> heldBy(Words words) {
    return words
        .string("held-by")
        .map(manager -> new HeldElsewhere(manager, words.string("held-for").orElse(manager)));
  }

  /**
   * @param now the time of the clock on which its deadline is: others have other clocks
   */
  public static Content want(ComponentWant want, Duration now) {
    return content("want", want, now);
  }

  /** The same, said to the holder. */
  public static Content yieldTo(ComponentWant want, Duration now) {
    return content("yield", want, now);
  }

  private static Content content(String operator, ComponentWant want, Duration now) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("member", Words.name(want.member())));
    arguments.add(Words.named("goal", Words.name(want.goalId())));
    arguments.add(names("components", want.components()));
    arguments.add(Words.named("priority", Words.number(want.standing().priority())));
    arguments.add(Words.named("grade", Words.number(want.standing().grade())));
    want.standing()
        .deadline()
        .ifPresent(
            deadline ->
                arguments.add(
                    Words.named("left", Words.number((double) deadline.minus(now).toMillis()))));
    return new Content(operator, arguments);
  }

  private static Content.Argument.Named names(String title, Set<String> components) {
    return Words.named(title, components.stream().sorted().map(Words::name).toList());
  }

  /**
   * What is wanted; empty when the message does not say of whom, for what goal, or what.
   *
   * @param now the time of the reader's clock
   */
  public static Optional<ComponentWant> want(Words words, Duration now) {
    Optional<String> member = words.string("member");
    Optional<String> goal = words.string("goal");
    Set<String> components = new TreeSet<>(words.strings("components"));
    if (member.isEmpty() || goal.isEmpty() || components.isEmpty()) {
      return Optional.empty();
    }
    GoalPriority standing =
        new GoalPriority(
            (int) words.number("priority", 0),
            (int) words.number("grade", GoalPriority.UNWEIGHED),
            words.find("left").map(left -> now.plusMillis((long) words.number("left", 0))),
            0);
    return Optional.of(new ComponentWant(goal.get(), standing, member.get(), components));
  }

  /** Said by who wanted it; the same words without components are read as an end of it. */
  public static Content wantNoMore(String goalId, String member) {
    return Words.content(
        "want", Words.named("member", Words.name(member)), Words.named("goal", Words.name(goalId)));
  }

  public static Content giveBack(String member, Set<String> components) {
    return Words.content(
        "give-back", Words.named("member", Words.name(member)), names("components", components));
  }

  public static Content wantedNoMore(String goalId, String member) {
    return Words.content(
        "inform",
        Words.named("member", Words.name(member)),
        Words.named("wanted-no-more", Words.name(goalId)));
  }

  public static Content got(String member, Set<String> components) {
    return Words.content(
        "inform", Words.named("member", Words.name(member)), names("got", components));
  }

  /** Whether they are news of what was wanted. */
  public static boolean areIn(Words words) {
    return words.string("wanted-no-more").isPresent() || !words.strings("got").isEmpty();
  }

  public static void tell(Words words, Coordinator coordinator) {
    String member = words.string("member").orElse("");
    words.string("wanted-no-more").ifPresent(goal -> coordinator.wantedNoMore(goal, member));
    Set<String> got = new TreeSet<>(words.strings("got"));
    if (!got.isEmpty()) {
      coordinator.gotComponents(member, got);
    }
  }
}
