package org.maestro.rats.member;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One question for prices (Three-layered architecture, 3.2.2; M54), until all of them are known or
 * its time is over. Clock thread only.
 */
final class CostInquiry {

  private static final Logger LOG = LoggerFactory.getLogger(CostInquiry.class);

  /** Wall time from the question to its answer: planning waits for it. */
  private static final Duration LIMIT = Duration.ofMillis(50);

  private final String member;
  private final MemberProfile.Feature feature;
  private final List<Map<String, Object>> sets;
  private final BiConsumer<Map<String, Object>, CostAnswer> told;
  private final List<Optional<CostAnswer>> answers;
  private Optional<Clock.Timer> limit = Optional.empty();
  private int open;
  private boolean over;

  /**
   * @param told each price as it becomes known, with its parameter set
   */
  CostInquiry(
      String member,
      MemberProfile.Feature feature,
      List<Map<String, Object>> sets,
      BiConsumer<Map<String, Object>, CostAnswer> told) {
    this.member = member;
    this.feature = feature;
    this.sets = sets;
    this.told = told;
    this.answers = new ArrayList<>(Collections.nCopies(sets.size(), Optional.empty()));
    this.open = sets.size();
  }

  /**
   * Asks the feature's procedure.
   *
   * @param all told the answers in the order of the sets, or
   * @param late told why they are not there in time; one of both is told, once
   */
  void begin(Clock clock, Consumer<List<CostAnswer>> all, Consumer<String> late) {
    for (int index = 0; index < sets.size(); index++) {
      ask(index, all);
    }
    if (sets.isEmpty()) {
      all.accept(List.of());
    } else if (!over) {
      Duration wall = clock.ofWall(LIMIT);
      limit = Optional.of(clock.schedule(wall, member, () -> tooLate(late)));
    }
  }

  private void ask(int index, Consumer<List<CostAnswer>> all) {
    try {
      feature.procedure().cost(sets.get(index), answer -> answered(index, sound(answer), all));
    } catch (RuntimeException fault) {
      logBroken(member, feature, fault);
      answered(index, none("the price could not be computed"), all);
    }
  }

  /** What JSON cannot hold, or is no amount, is no price. */
  private CostAnswer sound(CostAnswer answer) {
    boolean amounts =
        Stream.concat(answer.cost().stream(), answer.seconds().stream())
            .allMatch(amount -> Double.isFinite(amount) && amount >= 0);
    return amounts ? answer : none("the price that was computed is no amount");
  }

  private void answered(int index, CostAnswer answer, Consumer<List<CostAnswer>> all) {
    if (over || answers.get(index).isPresent()) {
      return;
    }
    answers.set(index, Optional.of(answer));
    open--;
    told.accept(sets.get(index), answer);
    if (open == 0) {
      over = true;
      limit.ifPresent(Clock.Timer::cancel);
      all.accept(answers.stream().flatMap(Optional::stream).toList());
    }
  }

  private void tooLate(Consumer<String> late) {
    if (!over) {
      over = true;
      late.accept(
          "%s does not know after %d ms what %d of %d parameter sets of %s would cost; ask later"
              .formatted(member, LIMIT.toMillis(), open, sets.size(), feature.id()));
    }
  }

  /** The procedure broke off instead of telling its price. */
  static void logBroken(String member, MemberProfile.Feature feature, RuntimeException fault) {
    LOG.error("The price of {} of {} could not be computed", feature.id(), member, fault);
  }

  private static CostAnswer none(String reason) {
    return new CostAnswer(Optional.empty(), Optional.empty(), Optional.of(reason));
  }
}
