package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Result;
import org.maestro.sl.Term;
import org.slf4j.LoggerFactory;

/** What a member says that is no MAESTRO-SL costs one line of log, and nothing else. */
@Isolated("other tests write to the log")
class SaidFactsTest {
  private long statesHeard;
  private static final String GOOD = "(= (level lamp-1) 0.5)";

  private final Logger ours = (Logger) LoggerFactory.getLogger(SaidFacts.class);
  private final ListAppender<ILoggingEvent> log = new ListAppender<>();
  private final List<String> heard = new ArrayList<>();

  @BeforeEach
  void listen() {
    log.start();
    ours.addAppender(log);
    ours.setAdditive(false);
  }

  @AfterEach
  void stopListening() {
    ours.detachAppender(log);
    ours.setAdditive(true);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "lit",
        "(",
        "(level lamp-b1",
        "(in Cup zone-a) (in Bob zone-a)",
        "(in ?x zone-a)",
        "(= (level lamp-1) ?l)",
        "(= (level lamp-1) 1e999)",
        "(= level)",
        "{\"level\": 1}",
        "((((((((((((((((in Cup",
        "(and (in Cup zone-a))\u0000"
      })
  void whatCannotBeReadIsPassedOverWithOneLine(String junk) {
    MemberNews news = news();
    for (int time = 0; time < 20; time++) {
      news.changed(lamp(List.of(junk, GOOD)));
    }
    assertThat(heard).hasSize(20).containsOnly("[" + GOOD + "]");
    assertThat(log.list).singleElement().matches(event -> event.getThrowableProxy() == null);
  }

  @Test
  void soAreReasonsOfAFailure() {
    List<ActionDispatcher.Report> reports = new ArrayList<>();
    CallReporter reporter =
        new CallReporter(
            Runnable::run,
            fact -> fact,
            new CallReporter.Listener() {
              @Override
              public void reported(Outcome outcome, ActionDispatcher.Report report) {
                reports.add(report);
              }

              @Override
              public void learnt(Map<String, Term> outputs) {
                throw new AssertionError();
              }

              @Override
              public void over() {
                // It is.
              }
            });
    RatsError error =
        new RatsError(
            ErrorCode.PRECONDITION_NOT_MET,
            RatsError.Level.WARNING,
            "It is too dark.",
            Optional.empty(),
            List.of(
                new RatsError.Reference("too dark", "light", 3),
                new RatsError.Reference("(illuminance zone-a)", "72", 3)),
            true);
    reporter.ended(
        new Result("c1", "cam-1", Outcome.FAILED, "standby", Map.of(), Optional.of(error)));
    assertThat(reports).hasSize(1);
    assertThat(reports.get(0).refs())
        .extracting(FeatureRun.Learnt::fact)
        .containsExactly("(illuminance zone-a)");
    assertThat(log.list)
        .singleElement()
        .extracting(ILoggingEvent::getFormattedMessage)
        .asString()
        .contains("cam-1", "too dark");
  }

  private MemberNews news() {
    Device device =
        new HomeLoader()
            .load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"))
            .devices()
            .get("lamp-b1");
    return new MemberNews(
        "lamp-b1",
        new MemberView("listener", () -> {}),
        (description, speaker) -> device,
        new MemberNews.Listener() {
          @Override
          public void described(String description) {
            // It is, with the first news.
          }

          @Override
          public void said(MemberWord word) {
            heard.add(word.facts().toString());
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
  }

  private RatsLink.Member lamp(List<String> facts) {
    return new RatsLink.Member(
        "lamp-b1",
        MemberStatus.Phase.READY,
        "b",
        Optional.of("{}"),
        Optional.of(
            new MemberState("lamp-b1", "b", "standby", facts, List.of(), List.of(), List.of())),
        ++statesHeard);
  }
}
