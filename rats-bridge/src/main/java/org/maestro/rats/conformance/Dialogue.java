package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Topics;

/** Calls of one device, and their results; waits for them. One thread. */
final class Dialogue {

  private final Examiner examiner;
  private final Topics topics;
  private final String member;
  private final Patience patience;

  Dialogue(Examiner examiner, Topics topics, String member, Patience patience) {
    this.examiner = examiner;
    this.topics = topics;
    this.member = member;
    this.patience = patience;
  }

  /** A new call, not sent yet. */
  Map<String, Object> call(String feature, Map<String, Object> parameters) {
    return examiner.call(examiner.newId(), feature, parameters);
  }

  Map<String, Object> ping() {
    return call("$ping", Map.of());
  }

  /** Sends the call, and waits for its result. */
  Optional<JsonNode> result(Map<String, Object> call) {
    int since = examiner.now();
    examiner.send(call);
    return result(since, call, patience.answersWithin());
  }

  /** The result that came since then, or comes in time. */
  Optional<JsonNode> result(int since, Map<String, Object> call, Duration atMost) {
    return examiner
        .await(since, heard -> isResult(heard, call), atMost)
        .map(Examiner.Heard::content);
  }

  boolean isResult(Examiner.Heard heard, Map<String, Object> call) {
    boolean isFromIt =
        List.of(topics.result(examiner.name(), member), topics.result(Examiner.OTHER, member))
                .contains(heard.topic())
            || heard.topic().equals(topics.bareResult())
                && heard.content().path("from").asText().equals(member);
    return isFromIt && heard.content().path("id").asText().equals(call.get("id"));
  }

  Finding answeredOrNot(DeviceRule rule, int since, Map<String, Object> call, String what) {
    Optional<JsonNode> result = result(since, call, patience.answersWithin());
    return outcome(result).equals("SUCCEEDED")
        ? kept(rule, what + " is answered")
        : broken(rule, what + (result.isEmpty() ? " is not answered" : " is " + outcome(result)));
  }

  Finding succeeds(DeviceRule rule, String feature) {
    Optional<JsonNode> result = result(call(feature, Map.of()));
    return outcome(result).equals("SUCCEEDED")
        ? kept(rule, feature + " succeeds")
        : broken(
            rule, feature + (result.isEmpty() ? " is not answered" : " is " + outcome(result)));
  }

  Finding refused(DeviceRule rule, Map<String, Object> call, String code, String what) {
    int since = examiner.now();
    examiner.send(call);
    return refused(rule, since, call, code, what);
  }

  /** Whether a call that was sent since then is refused. */
  Finding refused(DeviceRule rule, int since, Map<String, Object> call, String code, String what) {
    Optional<JsonNode> result = result(since, call, patience.answersWithin());
    String got = result.map(node -> node.path("error").path("code").asText()).orElse("");
    if (result.isEmpty()) {
      return broken(rule, what + " is not answered; it is to be refused with " + code);
    }
    return got.equals(code)
        ? kept(rule, what + " is refused with " + code)
        : broken(
            rule,
            "%s is %s%s; it is to be refused with %s"
                .formatted(what, outcome(result), got.isEmpty() ? "" : " with " + got, code));
  }

  Finding survives(DeviceRule rule, String what) {
    return result(ping()).isPresent()
        ? kept(rule, "it answers after " + what)
        : broken(rule, "it does not answer after " + what);
  }

  static String outcome(Optional<JsonNode> result) {
    return result.map(node -> node.path("outcome").asText()).orElse("");
  }
}
