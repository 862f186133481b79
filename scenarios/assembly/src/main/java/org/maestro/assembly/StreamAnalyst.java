package org.maestro.assembly;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.device.tasks.FactTemplates;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A member that tells what frames of another's stream show: how bright pictures are and how much in
 * them moves, how strong and high sound is (ADE, 3.3; A44). It may be in any process, far from the
 * camera. Frames come on the clock's thread; any thread may close it.
 */
public final class StreamAnalyst implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(StreamAnalyst.class);
  private static final Duration TELLS_EVERY = Duration.ofMillis(500);
  private static final String PICTURES = "image/";

  private final Clock clock;
  private final Findings findings;
  private final RatsMember member;
  private final FrameMeasures pictures = new PictureMeasures();
  private final FrameMeasures sounds = new SoundMeasures();
  private Duration tellsNext;
  private boolean willTell;
  private boolean hasComplained;

  private StreamAnalyst(Findings findings, RatsMember member, Clock clock) {
    this.findings = findings;
    this.member = member;
    this.clock = clock;
    this.tellsNext = clock.now();
  }

  /**
   * Joins the site; it says nothing before the first frame.
   *
   * @param id the member's
   * @param policy of the site
   * @param transport not open yet; closed with this
   */
  public static StreamAnalyst start(
      String id, CallPolicy policy, Transport transport, String site, Clock clock) {
    String description = StreamMember.description("analyst", id);
    Findings findings = new Findings(new FactTemplates(id, StreamMember.reports(description)));
    RatsMember member =
        RatsMember.start(
            StreamMember.profile(id, description, Map.of()),
            findings,
            transport,
            site,
            policy,
            clock);
    return new StreamAnalyst(findings, member, clock);
  }

  /** Takes the next frame of the stream. */
  public void add(StreamFrame frame) {
    try {
      FrameMeasures kind = frame.mediaType().startsWith(PICTURES) ? pictures : sounds;
      findings.take(kind.of(frame));
    } catch (IllegalArgumentException nothing) {
      complain(frame, nothing);
      return;
    }
    if (!willTell) {
      willTell = true;
      clock.schedule(tellsNext.minus(clock.now()), member.id(), this::tell);
    }
  }

  private void tell() {
    willTell = false;
    tellsNext = clock.now().plus(TELLS_EVERY);
    member.stateChanged();
  }

  private void complain(StreamFrame frame, IllegalArgumentException nothing) {
    if (!hasComplained) {
      hasComplained = true;
      LOG.warn(
          "Of what {} streams ({}) nothing can be said: {}.",
          frame.from(),
          frame.mediaType(),
          nothing.getMessage());
    }
  }

  @Override
  public void close() {
    member.leave();
    member.close();
  }

  /** What the latest frames say. Clock thread only. */
  private static final class Findings implements MemberProfile.Values {
    /** Finer than people and plans need; more would be told each time for the noise alone. */
    private static final double STEPS = 100;

    private static final Set<String> PASSING = Set.of("motion", "strength");

    private final FactTemplates reports;
    private final Map<String, Double> measured = new TreeMap<>();
    private boolean areTold = true;

    Findings(FactTemplates reports) {
      this.reports = reports;
    }

    /** Of what is over in a moment, the most since it was told last. */
    void take(Map<String, Double> values) {
      boolean isFirst = areTold;
      values.forEach(
          (word, value) ->
              measured.merge(
                  word,
                  value,
                  (before, now) ->
                      PASSING.contains(word) && !isFirst ? Math.max(before, now) : now));
      areTold = false;
    }

    @Override
    public List<String> current() {
      areTold = true;
      List<String> facts = new ArrayList<>();
      measured.forEach(
          (word, value) ->
              reports
                  .statement(word, new Term.Number(Math.rint(value * STEPS) / STEPS))
                  .ifPresent(facts::add));
      return facts;
    }
  }
}
