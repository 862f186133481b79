package org.maestro.rats.member;

import java.time.Duration;
import java.util.Map;

/**
 * The rate at which a continuous feature tells values, Freq (Three-layered architecture, 3.2.2;
 * M52).
 */
public sealed interface Frequency {

  /** The parameter by which a caller asks for fewer values: a number, in hertz. */
  String WANTED = "frequency";

  /** As often as the procedure observes something. */
  Frequency AS_IT_COMES = new UpTo(1_000);

  /** Always the same; what callers wish changes nothing. */
  record Fixed(double hertz) implements Frequency {
    public Fixed {
      require(hertz);
    }

    @Override
    public Duration period(Map<String, Object> parameters) {
      return every(hertz);
    }
  }

  /** At most so often; a caller may ask for less. */
  record UpTo(double hertz) implements Frequency {
    public UpTo {
      require(hertz);
    }

    @Override
    public Duration period(Map<String, Object> parameters) {
      return every(Math.min(hertz, wanted(parameters, hertz)));
    }
  }

  /** The time from one value to the next for a call with these parameters. */
  Duration period(Map<String, Object> parameters);

  private static Duration every(double hertz) {
    return Duration.ofNanos(Math.round(1e9 / hertz));
  }

  private static double wanted(Map<String, Object> parameters, double otherwise) {
    return parameters.get(WANTED) instanceof Number number && number.doubleValue() > 0
        ? number.doubleValue()
        : otherwise;
  }

  private static void require(double hertz) {
    if (!(hertz > 0) || Double.isInfinite(hertz)) {
      throw new IllegalArgumentException("A frequency is above 0 Hz and finite, not " + hertz);
    }
  }
}
