package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;

import java.util.List;
import java.util.Optional;
import org.maestro.rats.protocol.MessageCheck;

/** Whether all that a device has said is what the documents of version 1 describe. */
final class Documents {

  private final Bench bench;
  private final MessageCheck check;

  Documents(Bench bench) {
    this.bench = bench;
    this.check = new MessageCheck(bench.topics());
  }

  /**
   * @param notRetained what the broker does not keep of what it has to
   */
  Finding finding(List<String> notRetained) {
    if (!notRetained.isEmpty()) {
      return broken(
          DeviceRule.DOCUMENTS, String.join(", ", notRetained) + " came without retain flag");
    }
    if (bench.examiner().isAnswerKept()) {
      return broken(DeviceRule.DOCUMENTS, "its results have the retain flag");
    }
    List<Examiner.Heard> all = bench.examiner().since(0).stream().filter(this::isItsOwn).toList();
    return all.stream()
        .map(this::faultOf)
        .flatMap(Optional::stream)
        .findFirst()
        .map(fault -> broken(DeviceRule.DOCUMENTS, fault))
        .orElseGet(
            () ->
                kept(
                    DeviceRule.DOCUMENTS,
                    "status, description and state are retained; %d messages are as described"
                        .formatted(all.size())));
  }

  /** Others answer, too, what is asked of everybody. */
  private boolean isItsOwn(Examiner.Heard heard) {
    return bench
        .topics()
        .memberOf(heard.topic())
        .or(() -> bench.topics().senderOf(heard.topic()))
        .orElseGet(() -> heard.content().path("from").asText())
        .equals(bench.member());
  }

  private Optional<String> faultOf(Examiner.Heard heard) {
    if (!heard.isEmpty() && heard.content().isMissingNode()) {
      return Optional.of("what it says on %s is no JSON".formatted(heard.topic()));
    }
    byte[] payload = heard.isEmpty() ? new byte[0] : heard.content().toString().getBytes(UTF_8);
    // What the broker keeps that it should not is judged for itself.
    return check
        .fault(heard.topic(), payload, false)
        .map(fault -> "on %s: %s".formatted(heard.topic(), fault));
  }
}
