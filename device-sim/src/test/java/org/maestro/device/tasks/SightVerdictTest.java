package org.maestro.device.tasks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;

class SightVerdictTest {

  /** Sees nothing below 70 lux and above 1,000, everything between. */
  private static final Camera CAMERA =
      new Camera() {
        @Override
        public void look(Target target, int frames, Listener listener) {
          throw new UnsupportedOperationException("verdicts need no look");
        }

        @Override
        public void photograph(PhotoListener listener) {
          throw new UnsupportedOperationException("verdicts need no picture");
        }

        @Override
        public void photograph(int widest, PhotoListener listener) {
          throw new UnsupportedOperationException("verdicts need no picture");
        }

        @Override
        public double minimumLux() {
          return 72;
        }

        @Override
        public double maximumLux() {
          return 1000;
        }

        @Override
        public double detectability(double lux) {
          return lux >= 70 && lux <= 1000 ? 0.99 : 0;
        }

        @Override
        public double frameRate() {
          return 30;
        }

        @Override
        public double shareInView(String area) {
          return 1;
        }
      };

  private static SightVerdict verdict(
      int detections, double reference, double darkest, double brightest) {
    return SightVerdict.of(
        new Camera.Look(
            15,
            detections,
            detections > 0 ? Optional.of(new Position(0, 0, 0)) : Optional.empty(),
            List.of(new Camera.AreaLight("z", reference, darkest, brightest))),
        CAMERA);
  }

  @Test
  void findsWhatSeveralFramesShowInWhateverLight() {
    assertThat(verdict(3, 17, 17, 17).found()).isTrue();
    assertThat(verdict(2, 80, 80, 80).found()).isFalse();
  }

  @Test
  void excludesInLightThatIsGoodEverywhere() {
    assertThat(verdict(0, 80, 71, 200).unfit()).isEmpty();
  }

  @Test
  void namesTheLightThatIsNotFit() {
    assertThat(verdict(0, 16.52, 15, 20).unfit())
        .containsExactly(new SightVerdict.UnfitLight("z", 16.5, ">= 72", false));
    assertThat(verdict(0, 80, 45, 90).unfit())
        .containsExactly(new SightVerdict.UnfitLight("z", 45, ">= 72", false));
    assertThat(verdict(0, 2000, 1500, 2500).unfit())
        .containsExactly(new SightVerdict.UnfitLight("z", 2000, "<= 1000", false));
    assertThat(verdict(0, 900, 800, 1500).unfit())
        .containsExactly(new SightVerdict.UnfitLight("z", 1500, "<= 1000", true));
  }

  @Test
  void trustsNoColourWhereSomethingIsOverLit() {
    Camera.AreaLight light = new Camera.AreaLight("z", 400, 300, 60_000);
    SightVerdict verdict =
        SightVerdict.of(
            new Camera.Look(
                15, 15, Optional.of(new Position(0, 0, 0)), List.of(light), List.of(light)),
            CAMERA);
    assertThat(verdict.found()).isFalse();
    assertThat(verdict.unfit())
        .containsExactly(new SightVerdict.UnfitLight("z", 60_000, "<= 1000", true));
  }

  @Test
  void knowsTheChanceOfAMiss() {
    // fewer than 3 of 15: (1-p)^15 + 15 p (1-p)^14 + 105 p^2 (1-p)^13, at p = 0.5: 121 / 2^15
    assertThat(SightVerdict.missProbability(15, 0.5)).isCloseTo(121 / 32768.0, within(1e-12));
    assertThat(SightVerdict.missProbability(15, 0.98)).isLessThan(1e-6);
    assertThat(SightVerdict.missProbability(15, 0)).isEqualTo(1);
  }
}
