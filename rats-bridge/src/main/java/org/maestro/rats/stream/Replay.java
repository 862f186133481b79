package org.maestro.rats.stream;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.time.Clock;

/**
 * Streams a recording once, as fast as it was captured, as if it were captured now: whoever
 * receives a camera's stream receives this one. Clock thread only.
 */
public final class Replay implements Procedure {
  private static final double SECONDS = 0.1;

  private final Recording recording;
  private final String member;
  private final Clock clock;

  /**
   * @param member whose feature it is
   */
  public Replay(Recording recording, String member, Clock clock) {
    this.recording = recording;
    this.member = member;
    this.clock = clock;
  }

  @Override
  public void start(Execution execution) {
    execution.established(Map.of("frames", recording.frames().size()));
    play(execution, 0);
  }

  private void play(Execution execution, int frame) {
    if (execution.ended()) {
      return;
    }
    if (frame == recording.frames().size()) {
      execution.succeed(Map.of("frames", frame));
      return;
    }
    StreamFrame next = recording.frames().get(frame);
    execution.streamed(clock.now(), next.mediaType(), next.data());
    boolean isLast = frame + 1 == recording.frames().size();
    clock.schedule(
        isLast ? Duration.ZERO : recording.offset(frame + 1).minus(recording.offset(frame)),
        member,
        () -> play(execution, frame + 1));
  }

  @Override
  public CostAnswer cost(Map<String, Object> parameters) {
    return new CostAnswer(Optional.of(SECONDS), Optional.of(SECONDS), Optional.empty());
  }
}
