package org.maestro.sim.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SkyTest {

  private static final int EQUINOX = 81;

  @Test
  void theSunStandsSouthAtNoonAndInTheWestInTheEvening() {
    Sun noon = Sun.at(50, EQUINOX, 12);
    assertThat(noon.elevationDegrees()).isCloseTo(40, within(1e-9));
    assertThat(noon.east()).isCloseTo(0, within(1e-9));
    assertThat(noon.north()).isCloseTo(-Math.sin(Math.toRadians(50)), within(1e-9));

    Sun evening = Sun.at(50, EQUINOX, 18);
    assertThat(evening.elevationDegrees()).isCloseTo(0, within(1e-9));
    assertThat(evening.east()).isCloseTo(-1, within(1e-9));

    // midsummer: declination 23.45 degrees, so 90 - 50 + 23.45
    assertThat(Sun.at(50, 172, 12).elevationDegrees()).isCloseTo(63.45, within(0.001));
    assertThat(Sun.at(50, 172, 0).elevationDegrees()).isCloseTo(-16.55, within(0.001));
  }

  @Test
  void aClearSkyAndTheSunGiveWhatTheStandardSays() {
    Outdoors clear = new Sky(50, EQUINOX, 12, Clouds.NONE).at(Duration.ZERO);
    // sin 40 = 0.64279: 800 + 15500 * 0.64279^0.5; 127500 * 1.00712 * exp(-0.21 / 0.64279)
    assertThat(clear.clearHorizontal()).isCloseTo(13_227, within(1.0));
    assertThat(clear.overcastHorizontal()).isZero();
    assertThat(clear.directNormal()).isCloseTo(92_620, within(5.0));
    assertThat(clear.horizontal()).isCloseTo(13_227 + 92_620 * 0.642788, within(5.0));
    // upon a south wall: cos 40 of the sun; half of the sky; a tenth of what falls on the ground
    assertThat(clear.sunUponWall(0, -1)).isCloseTo(92_620 * 0.766044, within(5.0));
    assertThat(clear.sunUponWall(0, 1)).isZero();
    assertThat(clear.diffuseUponWall()).isCloseTo(6613.5 + 7276.2, within(2.0));
  }

  @Test
  void anOvercastSkyHidesTheSun() {
    Outdoors overcast = new Sky(50, EQUINOX, 12, Clouds.steady(1)).at(Duration.ZERO);
    assertThat(overcast.directNormal()).isZero();
    // 300 + 21000 * 0.64279, of which an upright wall sees 39.6 % and the ground's tenth
    assertThat(overcast.horizontal()).isCloseTo(13_798.5, within(1.0));
    assertThat(overcast.diffuseUponWall()).isCloseTo(13_798.5 * 0.496, within(1.0));
  }

  @Test
  void twilightFadesIntoNight() {
    Sky sky = new Sky(50, EQUINOX, 18, Clouds.NONE);
    assertThat(sky.at(Duration.ZERO).horizontal()).isCloseTo(800, within(1.0));
    // the sun sinks by 15 degrees times cos 50 an hour: 6 degrees below after some 37 minutes
    assertThat(sky.at(Duration.ofSeconds(2243)).horizontal()).isCloseTo(6.8, within(0.2));
    assertThat(sky.at(Duration.ofHours(6)).horizontal()).isZero();
    assertThat(sky.at(Duration.ofHours(18)).horizontal()).isGreaterThan(70_000);
  }

  @Test
  void cloudsAreTheSameForTheSameSeed() {
    assertThat(covers(7)).isEqualTo(covers(7)).isNotEqualTo(covers(8));
    assertThat(covers(7)).allMatch(cover -> cover >= 0 && cover <= 1);
    assertThat(covers(7).stream().mapToDouble(cover -> cover).average().orElseThrow())
        .isBetween(0.3, 0.7);
  }

  @Test
  void cloudsChangeEvenlyFromOneValueToTheNext() {
    Clouds clouds = new Clouds(0.5, 0.4, Duration.ofMinutes(10), 3);
    double begin = clouds.at(Duration.ZERO);
    double end = clouds.at(Duration.ofMinutes(10));
    assertThat(clouds.at(Duration.ofMinutes(4)))
        .isCloseTo(begin + 0.4 * (end - begin), within(1e-9));
  }

  private static List<Double> covers(long seed) {
    Clouds clouds = new Clouds(0.5, 0.8, Duration.ofMinutes(10), seed);
    return IntStream.range(0, 100)
        .mapToObj(minutes -> clouds.at(Duration.ofMinutes(7L * minutes)))
        .toList();
  }
}
