package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;

/** What nobody should send: other versions, what is too big or too deep, and rubbish. */
final class BadCalls {

  private static final int MANY = 100;
  private static final int DEEP = 200;

  private final Examiner examiner;
  private final Dialogue dialogue;
  private final Topics topics;
  private final String member;

  BadCalls(Bench bench) {
    this.examiner = bench.examiner();
    this.dialogue = bench.dialogue();
    this.topics = bench.topics();
    this.member = bench.member();
  }

  /** What a device answers that goes on. */
  List<Finding> odd() {
    return List.of(laterMinor(), otherMajor(), namedField(), halfCharacter());
  }

  /** What may be the end of a device. */
  List<Finding> dangerous() {
    Finding big = tooBig();
    return big.verdict() == Finding.Verdict.BROKEN
        ? List.of(big, notTried(DeviceRule.RUBBISH, "it does not answer any more"))
        : List.of(big, rubbish());
  }

  private Finding laterMinor() {
    Map<String, Object> call = dialogue.ping();
    call.put("v", "1.99");
    call.put("fromTheFuture", Map.of("a", 1));
    int since = examiner.now();
    examiner.send(call);
    return dialogue.answeredOrNot(
        DeviceRule.LATER_MINOR, since, call, "a call of version 1.99 with an unknown field");
  }

  private Finding otherMajor() {
    Map<String, Object> call = dialogue.ping();
    call.put("v", "2.0");
    return dialogue.refused(
        DeviceRule.OTHER_MAJOR, call, "UNSUPPORTED_VERSION", "a call of version 2.0");
  }

  private Finding halfCharacter() {
    Map<String, Object> call = dialogue.ping();
    String text = new String(examiner.bytes(call), UTF_8);
    int since = examiner.now();
    examiner.send(
        topics.call(examiner.name()), text.replace("{}", "{\"x\":\"\\ud800\"}").getBytes(UTF_8));
    return dialogue.refused(
        DeviceRule.HALF_CHARACTER, since, call, "MALFORMED", "a call with half a character");
  }

  private Finding tooBig() {
    String deep = "[".repeat(DEEP) + "]".repeat(DEEP);
    String call = new String(examiner.bytes(dialogue.ping()), UTF_8);
    examiner.send(
        topics.call(examiner.name()), call.replace("{}", "{\"x\":" + deep + "}").getBytes(UTF_8));
    byte[] big = new byte[WireFormat.MOST_BYTES + 1];
    Arrays.fill(big, (byte) ' ');
    examiner.send(topics.call(examiner.name()), big);
    return dialogue.survives(DeviceRule.TOO_BIG, "what is too big and too deep");
  }

  private Finding rubbish() {
    List<String> rubbish =
        List.of(
            "{{",
            "[]",
            "null",
            "3",
            "\"call\"",
            "{}",
            "{\"id\":3}",
            "\u0000",
            "{\"id\":\"x\",\"r\":\"" + member + "\"}");
    for (int number = 0; number < MANY; number++) {
      examiner.send(
          topics.call(examiner.name()), rubbish.get(number % rubbish.size()).getBytes(UTF_8));
    }
    examiner.send(topics.call(examiner.name()), new byte[] {(byte) 0xff, (byte) 0xfe});
    return dialogue.survives(DeviceRule.RUBBISH, "a hundred broken messages");
  }

  private Finding namedField() {
    Map<String, Object> call = dialogue.ping();
    call.put("t", "soon");
    Optional<JsonNode> result = dialogue.result(call);
    if (result.isEmpty() || Dialogue.outcome(result).equals("SUCCEEDED")) {
      return notTried(
          DeviceRule.NAMED_FIELD,
          result.isEmpty()
              ? "it says nothing to a call whose t is a text"
              : "it takes a call whose t is a text");
    }
    JsonNode error = result.get().path("error");
    boolean names =
        error.path("code").asText().equals("MALFORMED")
            && error.path("message").asText().matches("(?s).*\\bt\\b.*");
    return names
        ? kept(DeviceRule.NAMED_FIELD, error.path("message").asText())
        : broken(DeviceRule.NAMED_FIELD, "of a call whose t is a text it says " + error);
  }
}
