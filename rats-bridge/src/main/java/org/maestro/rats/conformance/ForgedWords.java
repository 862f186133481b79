package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.WireFormat;

/** What others say in a device's name on an open site, which must not be the last word. */
final class ForgedWords {

  private static final String SECURED = "the site is secured: nobody else can say so";

  private final Bench bench;
  private static final int TRIES = 3;
  private static final String FORGED = "{\"label\":\"not what it is\"}";

  private final Appearance appearance;
  private final WireFormat wire = new WireFormat();

  ForgedWords(Bench bench, Appearance appearance) {
    this.bench = bench;
    this.appearance = appearance;
  }

  List<Finding> findings() {
    return List.of(
        end(DeviceRule.OWN_WILL, status(MemberStatus.Phase.LOST, appearance.boot())),
        end(DeviceRule.LATE_WILL, status(MemberStatus.Phase.LOST, otherBoot())),
        end(DeviceRule.FORGED_END, status(MemberStatus.Phase.DISCONNECTED, appearance.boot())),
        description());
  }

  Finding cleared() {
    return end(DeviceRule.CLEARED_STATUS, new byte[0]);
  }

  private String otherBoot() {
    return "0-never-" + appearance.boot();
  }

  private byte[] status(MemberStatus.Phase phase, String boot) {
    return wire.encode(new MemberStatus(bench.member(), phase, boot));
  }

  private Finding end(DeviceRule rule, byte[] status) {
    if (!bench.isOpen()) {
      return notTried(rule, SECURED);
    }
    int since = bench.examiner().now();
    bench.examiner().sendRetained(bench.topics().status(bench.member()), status);
    if (saysThatItIsThere(since)) {
      return kept(rule, "it says again that it is there");
    }
    contradict();
    return broken(rule, "it does not say again that it is there");
  }

  private boolean saysThatItIsThere(int since) {
    return bench
        .examiner()
        .await(
            since,
            heard ->
                heard.topic().equals(bench.topics().status(bench.member()))
                    && heard.content().path("status").asText().equals("ready"),
            bench.patience().answersWithin())
        .isPresent();
  }

  /** What was said in its name is withdrawn where it does not do so. */
  private void contradict() {
    bench
        .examiner()
        .sendRetained(
            bench.topics().status(bench.member()),
            status(MemberStatus.Phase.READY, appearance.boot()));
  }

  /** May be its end, and comes last. */
  Finding namesake() {
    if (!bench.isOpen()) {
      return notTried(DeviceRule.NAMESAKE, SECURED);
    }
    if (bench.dialogue().result(bench.dialogue().ping()).isEmpty()) {
      return notTried(DeviceRule.NAMESAKE, "it does not answer any more");
    }
    int since = bench.examiner().now();
    bench
        .examiner()
        .sendRetained(
            bench.topics().status(bench.member()), status(MemberStatus.Phase.READY, otherBoot()));
    // Topics may overtake each other; it is to read this one before the next.
    bench.examiner().await(since, heard -> false, bench.patience().silence());
    Finding found =
        bench
            .dialogue()
            .survives(DeviceRule.NAMESAKE, "another said to be it, and answers nothing");
    contradict();
    return found;
  }

  private Finding description() {
    Optional<JsonNode> own = appearance.description();
    if (!bench.isOpen() || own.isEmpty()) {
      return notTried(
          DeviceRule.FORGED_DESCRIPTION, bench.isOpen() ? "it describes nothing" : SECURED);
    }
    String topic = bench.topics().description(bench.member());
    // What it tells anew because of what came before is said by then.
    bench.dialogue().result(bench.dialogue().ping());
    for (int tries = 0; tries < TRIES; tries++) {
      if (isToldAgain(topic, own.get())) {
        return kept(DeviceRule.FORGED_DESCRIPTION, "it tells its own again");
      }
    }
    bench.examiner().sendRetained(topic, own.get().toString().getBytes(UTF_8));
    return broken(DeviceRule.FORGED_DESCRIPTION, "it does not tell its own again");
  }

  /**
   * Whether its own description is the last word after a forged one. Of two senders' messages a
   * broker may keep the earlier one, whatever the member does, so that once is no proof.
   */
  private boolean isToldAgain(String topic, JsonNode own) {
    int since = bench.examiner().now();
    bench.examiner().sendRetained(topic, FORGED.getBytes(UTF_8));
    return bench
            .examiner()
            .awaitAfter(
                since,
                heard -> heard.topic().equals(topic) && heard.content().toString().equals(FORGED),
                heard -> heard.topic().equals(topic) && heard.content().equals(own),
                bench.patience().answersWithin())
            .isPresent()
        || bench.examiner().stands(topic, own);
  }
}
