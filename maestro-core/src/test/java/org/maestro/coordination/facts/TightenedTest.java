package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What was just enough when it was measured is not enough for settings that are to last. */
class TightenedTest {
  @ParameterizedTest
  @CsvSource({
    "(>= (lux a) 100), (>= (lux a) 105)",
    "(> (lux a) 100), (> (lux a) 105)",
    "(<= (lux a) 100), (<= (lux a) 95)",
    "(< (lux a) 100), (< (lux a) 95)",
    "(>= 100 (lux a)), (>= 95 (lux a))",
    "(> 100 (lux a)), (> 95 (lux a))",
    "(<= 100 (lux a)), (<= 105 (lux a))",
    "(< 100 (lux a)), (< 105 (lux a))",
    "(>= (lux a) -100), (>= (lux a) -95)",
    "(<= (lux a) -100), (<= (lux a) -105)",
    "(>= (+ 1 (lux a)) 100), (>= (+ 1 (lux a)) 105)"
  })
  void theLimitMovesByAShareOfItsAmount(String condition, String tightened) {
    assertThat(tightened(condition)).isEqualTo(tightened);
  }

  @Test
  void aLimitThatIsNoPlainNumberMovesByTheSameShare() {
    assertThat(tightened("(>= (lux a) (least a))"))
        .isEqualTo("(>= (lux a) (+ (least a) (* 0.05 (max (least a) (- 0 (least a))))))");
    assertThat(tightened("(<= (lux a) (least a))"))
        .isEqualTo("(<= (lux a) (+ (least a) (* -0.05 (max (least a) (- 0 (least a))))))");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "(= (lux a) 100)",
        "(not (>= (lux a) 100))",
        "(>= (least a) 100)",
        "(in Cup a)",
        "(unknown (lux a))"
      })
  void whatHasNoMarginStaysAsItIs(String condition) {
    assertThat(tightened(condition)).isEqualTo(condition);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(and (in Cup a) (>= (lux a) 100)) | (and (in Cup a) (>= (lux a) 105))",
        "(or (in Cup a) (>= (lux a) 100)) | (or (in Cup a) (>= (lux a) 105))",
        "(exists (?z) (>= (lux ?z) 100)) | (exists (?z) (>= (lux ?z) 105))",
        "(forall (?z) (>= (lux ?z) 100)) | (forall (?z) (>= (lux ?z) 105))",
        "(imply (>= (lux a) 50) (>= (lux a) 100)) | (imply (>= (lux a) 50) (>= (lux a) 105))"
      })
  void partsThatHaveToHoldAreTightened(String condition, String tightened) {
    assertThat(tightened(condition)).isEqualTo(tightened);
  }

  private static String tightened(String condition) {
    return SlPrinter.print(Tightened.of(SlParser.formula(condition, "lux"::equals), "lux"::equals));
  }
}
