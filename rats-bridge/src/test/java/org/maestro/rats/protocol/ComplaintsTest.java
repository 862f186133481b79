package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** One line of log for each sender and minute. */
class ComplaintsTest {

  @Test
  void areDueOnceAMinuteForEachSender() {
    AtomicLong nanos = new AtomicLong();
    Complaints complaints = new Complaints(nanos::get);
    assertThat(complaints.isDue("a")).isTrue();
    assertThat(complaints.isDue("b")).isTrue();
    for (int second = 0; second < 59; second++) {
      nanos.addAndGet(TimeUnit.SECONDS.toNanos(1));
      assertThat(complaints.isDue("a")).isFalse();
    }
    nanos.addAndGet(TimeUnit.SECONDS.toNanos(1));
    assertThat(complaints.isDue("a")).isTrue();
    assertThat(complaints.isDue("a")).isFalse();
  }

  @Test
  void quoteNobodyAtLength() {
    assertThat(Complaints.shortened("short")).isEqualTo("short");
    assertThat(Complaints.shortened("x".repeat(300_000))).hasSizeLessThan(500).endsWith("x...");
  }
}
