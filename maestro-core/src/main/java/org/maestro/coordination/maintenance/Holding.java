package org.maestro.coordination.maintenance;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;

/**
 * The monitor of a held goal: whether it holds, and what is told when that changes. The
 * coordinator's thread only.
 */
final class Holding {
  /** Not those in names, such as {@code lamp-b1}. */
  private static final Pattern NUMBERS = Pattern.compile("(?<![\\w-])-?\\d+(\\.\\d+)?");

  private final Formula condition;
  private final GoalLife life;
  private final HeldStory story;
  private final Clock clock;
  private final Consumer<HeldNews> news;
  private final RetryBackoff patience = new RetryBackoff();
  private boolean holding;
  private boolean everHeld;
  private String lastReasons = "";

  Holding(Formula condition, GoalLife life, HeldStory story, Clock clock, Consumer<HeldNews> news) {
    this.condition = condition;
    this.life = life;
    this.story = story;
    this.clock = clock;
    this.news = news;
  }

  /**
   * @param before whether it was so before a restart
   */
  void takeUp(boolean before) {
    everHeld = before;
  }

  boolean isSo() {
    return holding;
  }

  boolean everWas() {
    return everHeld;
  }

  /** Whether it was tried in vain since it held last. */
  boolean isDespaired() {
    return !lastReasons.isEmpty();
  }

  /** Why it is tried again; empty when it was not in vain before. */
  String whyAgain() {
    return isDespaired() ? "tried again; it could not be kept so: " + lastReasons : "";
  }

  /** How long it is to be waited before it is tried again. */
  Duration pause() {
    return patience.left(clock.now());
  }

  /** Who takes part is not as it was. */
  void renewed() {
    patience.renewed(clock.now());
  }

  /**
   * It is so.
   *
   * @param confirmed not only by the word of who did it
   */
  void begins(Evidence evidence, boolean confirmed) {
    if (!holding) {
      holding = true;
      patience.held(clock.now());
      lastReasons = "";
      story.holds(condition, everHeld, evidence, confirmed);
      tell(everHeld ? HeldNews.Kind.HELD_AGAIN : HeldNews.Kind.HELD, confirmed, List.of());
      everHeld = true;
    }
    life.becomeIfNew(
        GoalPhase.HOLDING, evidence == Evidence.KNOWN ? "nobody can observe it all the time" : "");
  }

  void ceases() {
    if (holding) {
      holding = false;
      patience.lost(clock.now());
      story.lost(condition);
      tell(HeldNews.Kind.LOST, false, List.of());
    }
  }

  /** It could not be brought about; the same reasons in other numbers are not told again. */
  void failed(List<String> reasons) {
    patience.failed(clock.now());
    String before = lastReasons;
    lastReasons = String.join(" ", reasons);
    if (!withoutNumbers(lastReasons).equals(withoutNumbers(before))) {
      story.cannotBeHeld(reasons);
      tell(HeldNews.Kind.LOST, false, reasons);
    }
    awaits();
  }

  private static String withoutNumbers(String text) {
    return NUMBERS.matcher(text).replaceAll("");
  }

  void awaits() {
    life.becomeIfNew(
        GoalPhase.WAITING_TO_RETRY, lastReasons.isEmpty() ? "it is tried again soon" : lastReasons);
  }

  void suspended(String why) {
    life.becomeIfNew(GoalPhase.SUSPENDED, why);
  }

  private void tell(HeldNews.Kind kind, boolean confirmed, List<String> reasons) {
    news.accept(new HeldNews(life.id(), kind, confirmed, reasons));
  }
}
