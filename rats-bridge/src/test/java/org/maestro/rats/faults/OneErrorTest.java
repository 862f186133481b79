package org.maestro.rats.faults;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.security.LogLines;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;

/**
 * What a broken message costs: one line of log that names its sender, the field and the rule, and
 * an answer that says the same where the message tells whom to answer and what.
 */
@Isolated("other tests write to the log")
class OneErrorTest {

  private static final String CALL =
      "{'v':'1.0','id':'c1','r':'tim','f':'deed','p':{},'t':5000,'from':'vandal'}";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("home");
  @AutoClose private final LogLines log = LogLines.of("org.maestro.rats");
  private Vandal vandal;
  private RatsLink link;

  @BeforeEach
  void join() {
    Complaints ofTheHome = new Complaints();
    for (String id : List.of("rose", "tim", "ann")) {
      RatsMember.start(
          new CountingDevice(id, clock, Duration.ofMillis(5)).profile(),
          List::of,
          bus.client(id),
          "home",
          CallPolicy.OPEN,
          ofTheHome,
          clock);
    }
    link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    vandal = Vandal.join(bus, topics, clock);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "'id':'c1'|'id':'a b'|id|without space",
        "'id':'c1'|'id':''|id|1 to 128 characters",
        "'id':'c1'|'id':7|id|1 to 128 characters",
        "'id':'c1',|~~|id|1 to 128 characters",
        "'from':'vandal'|'from':'a/b'|from|a name of letters",
        "'from':'vandal'|'from':'ü+#'|from|a name of letters",
        "'f':'deed'|'f':'a/#'|f|without space, '/', '+' and '#'",
        "'f':'deed',|~~|f|without space, '/', '+' and '#'",
        "'r':'tim'|'r':7|r|a text",
        "'t':5000|'t':'5'|t|a whole number",
        "'t':5000|'t':0|t|a whole number from 1",
        "'p':{}|'p':[]|p|an object",
        "'p':{}|'p':{'a':{'b':[1,null]}}|p.a.b[1]|a text, a finite number",
        "'v':'1.0'|'v':1.0|v|a text such as",
        "'v':'1.0'|'v':'2.0'|v|major version 1",
        "'p':{}|'p':DEEP|payload|nested at most 16 deep",
        "'p':{}|'p':HUGE|payload|at most 262144 bytes",
        "{'v'|hello{'v'|payload|one JSON object"
      })
  void namesSenderFieldAndRuleOnce(String part, String wrong, String field, String rule) {
    String broken =
        CALL.replace(part, wrong)
            .replace("DEEP", "{'a':" + "[".repeat(1_000) + "]".repeat(1_000) + "}")
            .replace("HUGE", "{'a':'" + "x".repeat(1 << 20) + "'}")
            .replace('\'', '"');
    for (int again = 0; again < 3; again++) {
      say(topics.call("vandal"), broken);
    }

    assertThat(log.lines())
        .singleElement()
        .asString()
        .contains("vandal", "The message's " + field + " must be ", rule)
        .hasSizeLessThan(500);
    boolean saysWhomToAnswer =
        !List.of("id", "r", "payload").contains(field) || wrong.contains("DEEP");
    if (saysWhomToAnswer) {
      assertThat(vandal.results).hasSize(3).extracting(Result::from).containsOnly("tim");
      assertThat(vandal.results)
          .extracting(result -> result.error().map(RatsError::code).orElseThrow())
          .containsOnly(
              wrong.contains("2.0") ? ErrorCode.UNSUPPORTED_VERSION : ErrorCode.MALFORMED);
      assertThat(vandal.results.get(0).error().orElseThrow().message()).contains(field, rule);
    } else {
      assertThat(vandal.results).isEmpty();
    }
  }

  @Test
  void whatAllHearIsComplainedOfOnce() {
    String blank = CALL.replace("'r':'tim',", "").replace('\'', '"');
    vandal.publish(Publication.retained(topics.call("vandal"), blank.getBytes(UTF_8)));
    say(topics.call("vandal"), blank.replace("\"vandal\"", "\"cca\""));
    assertThat(log.lines()).hasSize(1);
    assertThat(vandal.results).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ghost|a b|id|a name of letters",
        "ghost|a/b|id|a name of letters",
        "ü|ü|id|a name of letters",
        "ghost|$share|id|a name of letters"
      })
  void membersOfImpossibleNamesAreNamedAndNotListed(
      String level, String id, String field, String rule) {
    int before = link.members().size();
    say(
        topics.status(level),
        "{\"v\":\"1.0\",\"id\":\"%s\",\"status\":\"ready\",\"boot\":\"b\"}".formatted(id));
    assertThat(log.lines())
        .singleElement()
        .asString()
        .contains(topics.status(level), "The message's " + field + " must be ", rule);
    assertThat(link.members()).hasSize(before);
  }

  @Test
  void aDescriptionIsNotLongerThanAnyMessage() {
    say(
        topics.status("ghost"),
        "{\"v\":\"1.0\",\"id\":\"ghost\",\"status\":\"ready\",\"boot\":\"b\"}");
    say(topics.description("ghost"), "x".repeat(300_000));
    assertThat(log.lines())
        .singleElement()
        .asString()
        .contains(topics.description("ghost"), "payload", "at most 262144 bytes");
    assertThat(link.members())
        .filteredOn(member -> member.id().equals("ghost"))
        .singleElement()
        .matches(member -> member.description().isEmpty());
  }

  private void say(String topic, String payload) {
    vandal.say(topic, payload.getBytes(UTF_8));
  }
}
