package org.maestro.rats.stream;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.Clock;

/** A member that streams a frame each tenth of a second, numbered in its data. */
final class Filming implements Procedure {
  static final Duration PERIOD = Duration.ofMillis(100);

  private final String member;
  private final String mediaType;
  private final Clock clock;

  Filming(String member, String mediaType, Clock clock) {
    this.member = member;
    this.mediaType = mediaType;
    this.clock = clock;
  }

  /** A member with one continuous feature. */
  static MemberProfile profile(String id, String feature, Procedure procedure) {
    return new MemberProfile(
        id,
        "{\"@id\":\"" + id + "\"}",
        Set.of("standby"),
        "standby",
        Set.of("standby"),
        Map.of(
            feature,
            new MemberProfile.Feature(
                feature, Set.of(), Set.of(), true, Optional.empty(), "standby", procedure)));
  }

  @Override
  public void start(Execution execution) {
    execution.established(Map.of());
    next(execution, 1);
  }

  private void next(Execution execution, int number) {
    clock.schedule(
        PERIOD,
        member,
        () -> {
          if (!execution.ended()) {
            execution.streamed(clock.now(), mediaType, data(number));
            next(execution, number + 1);
          }
        });
  }

  static byte[] data(int number) {
    byte[] data = new byte[1000 + number];
    for (int i = 0; i < data.length; i++) {
      data[i] = (byte) (number * 31 + i);
    }
    return data;
  }

  @Override
  public CostAnswer cost(Map<String, Object> parameters) {
    return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
  }
}
