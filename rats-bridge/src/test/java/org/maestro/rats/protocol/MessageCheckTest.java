package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Who only listens finds the same fault in a message as those whom it is for. */
class MessageCheckTest {
  private static final String LAMP_READY =
      "{\"v\": \"1.3\", \"id\": \"lamp\", \"status\": \"ready\", \"boot\": \"b1\"}";

  private final MessageCheck check = new MessageCheck(new Topics("home"));

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "member/lamp/status        | {\"v\": \"1.3\", \"id\": \"lamp\", \"status\": \"ready\", \"boot\": \"b1\"}",
        "controller/lamp/status    | {\"v\": \"1.3\", \"id\": \"lamp\", \"status\": \"ready\", \"boot\": \"b1\"}",
        "member/lamp/description   | whatever it says is judged by others",
        "call/cca                  | {\"v\": \"1.3\", \"id\": \"1\", \"f\": \"ring\", \"p\": {}, \"t\": 5, \"from\": \"cca\"}",
        "call                      | {\"v\": \"1.3\", \"id\": \"1\", \"f\": \"ring\", \"p\": {}, \"t\": 5, \"from\": \"cca\"}"
      })
  void whatIsAsTheDocumentsSayHasNoFault(String topic, String payload) {
    assertThat(fault(topic, payload, false)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "member/bell/status      | A message of lamp on the topic rats/1/home/member/bell/status is ignored",
        "member/lamp/state       | The message's z must be",
        "result/cca/lamp         | The message's outcome must be",
        "progress/cca/lamp       | The message's from must be",
        "member/lamp/observation/ring | The message's from must be",
        "controller/c/verdict/lamp    | The message's accepted must be",
        "member/lamp/mood        | No message of the bus has the topic rats/1/home/member/lamp/mood"
      })
  void whatIsOtherwiseIsNamed(String topic, String fault) {
    assertThat(fault(topic, LAMP_READY, false)).startsWith(fault);
  }

  @Test
  void aCallIsNotRetainedAndWhatIsRetainedIsWithdrawnByNothing() {
    assertThat(fault("call/cca", LAMP_READY, true)).contains("must not be retained");
    assertThat(fault("member/lamp/state", "", true)).isEmpty();
    assertThat(fault("result/cca/lamp", "", false)).contains("payload");
  }

  @Test
  void whatIsTooLongForEverybodyIsSo() {
    String tooLong = "x".repeat(WireFormat.MOST_BYTES + 1);

    assertThat(fault("member/lamp/description", tooLong, true)).contains("at most 262144 bytes");
    assertThat(fault("member/lamp/state", tooLong, true)).contains("at most 262144 bytes");
  }

  private String fault(String topic, String payload, boolean retained) {
    return check.fault("rats/1/home/" + topic, payload.getBytes(UTF_8), retained).orElse("");
  }
}
