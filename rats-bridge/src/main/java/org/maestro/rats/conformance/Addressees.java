package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Whether a device knows which calls are meant for it, from whom they are, and whom to answer. */
final class Addressees {

  private final Bench bench;
  private final Dialogue dialogue;

  Addressees(Bench bench) {
    this.bench = bench;
    this.dialogue = bench.dialogue();
  }

  List<Finding> findings() {
    return List.of(bareTopic(), blankReceiver(), resultNamesTheCall(), callOfAnother(), sender());
  }

  private Finding bareTopic() {
    if (!bench.isOpen()) {
      return notTried(DeviceRule.BARE_TOPIC, "the site is secured");
    }
    Map<String, Object> call = dialogue.ping();
    int since = bench.examiner().now();
    bench
        .examiner()
        .send("rats/1/" + bench.topics().site() + "/call", bench.examiner().bytes(call));
    return dialogue.answeredOrNot(DeviceRule.BARE_TOPIC, since, call, "a $ping on the topic call");
  }

  private Finding blankReceiver() {
    Map<String, Object> unknown = dialogue.call("neverWas", Map.of());
    unknown.remove("r");
    if (isAnswered(unknown)) {
      return broken(
          DeviceRule.BLANK_RECEIVER,
          "a call to everybody of a feature that it has not is answered");
    }
    Map<String, Object> call = dialogue.ping();
    call.remove("r");
    int since = bench.examiner().now();
    bench.examiner().send(call);
    return dialogue.answeredOrNot(
        DeviceRule.BLANK_RECEIVER, since, call, "a $ping without receiver");
  }

  private Finding resultNamesTheCall() {
    Map<String, Object> call = dialogue.ping();
    Optional<JsonNode> result = dialogue.result(call);
    String from = result.map(node -> node.path("from").asText()).orElse("");
    Set<String> missing = new LinkedHashSet<>();
    for (String field : List.of("v", "id", "from", "outcome", "z", "values")) {
      if (result.map(node -> node.path(field).isMissingNode()).orElse(true)) {
        missing.add(field);
      }
    }
    if (!missing.isEmpty()) {
      return broken(DeviceRule.RESULT, "the result of $ping lacks " + String.join(", ", missing));
    }
    return from.equals(bench.member())
        ? kept(DeviceRule.RESULT, "the result of $ping names call and device")
        : broken(DeviceRule.RESULT, "the result of $ping is from " + from);
  }

  private Finding callOfAnother() {
    Map<String, Object> call = dialogue.ping();
    call.put("r", "nobody-" + bench.examiner().newId());
    return isAnswered(call)
        ? broken(DeviceRule.WHO_WAS_CALLED, "a $ping of another device is answered")
        : kept(DeviceRule.WHO_WAS_CALLED, "a $ping of another device is not answered");
  }

  private Finding sender() {
    Map<String, Object> call = dialogue.ping();
    call.put("from", Examiner.OTHER);
    return isAnswered(call)
        ? broken(DeviceRule.SENDER, "a call in the name of another is answered")
        : kept(DeviceRule.SENDER, "a call in the name of another is not answered");
  }

  private boolean isAnswered(Map<String, Object> call) {
    int since = bench.examiner().now();
    bench.examiner().send(call);
    return dialogue.result(since, call, bench.patience().silence()).isPresent();
  }
}
