package org.maestro.coordination.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.rats.time.SteppedClock;

class PlanRecordsTest {
  private static final BidRecord BID =
      new BidRecord(
          OptionalInt.empty(), "rose", "pick", false, new BidRecord.Refused("no hand is free"));

  private final PlanRecords records = new PlanRecords(new SteppedClock());

  private void plan(int number, int bids) {
    records.planning(number, Optional.of("it is darker"));
    records.answered(Collections.nCopies(bids, BID), 0);
  }

  private List<Integer> numbers() {
    return records.all().stream().map(PlanRecord::number).toList();
  }

  @Test
  void theLatestTwentyAreKept() {
    for (int number = 1; number <= 25; number++) {
      plan(number, 3);
    }

    assertThat(numbers()).hasSize(20).startsWith(6).endsWith(25);
  }

  @Test
  void ofLargeOnesNoMoreThanThereIsRoomForAndTheLatestAlways() {
    plan(1, 1_000);
    plan(2, 1_000);
    assertThat(numbers()).containsExactly(2);

    plan(3, 10_000);
    assertThat(numbers()).containsExactly(3);
  }
}
