package org.maestro.hal.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Base64;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import javax.imageio.ImageIO;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.fixtures.RosbridgeServer;
import org.maestro.hal.Camera;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.rats.time.PacedClock;

/** Sensors and cameras behind rosbridge tell what is told, and say why they cannot (M89). */
class RosSensorsTest {
  private static final Target CUP = new Target("green-cup", Map.of());

  private final PacedClock clock = new PacedClock(1);
  private final RosbridgeServer server = new RosbridgeServer(0, 0, 0);
  private RosBridge bridge;

  @BeforeEach
  void open() {
    bridge = RosBridge.open(server.address(), RosVersion.ROS_2);
  }

  @AfterEach
  void close() {
    bridge.close();
    server.close();
    clock.close();
  }

  private void after(double seconds, Runnable next) {
    clock.schedule(Duration.ofNanos(Math.round(seconds * 1e9)), "sensor", next);
  }

  private static void await(Callable<Boolean> condition) {
    Awaitility.await().atMost(Duration.ofSeconds(30)).until(condition);
  }

  private static String outcome(CompletableFuture<String> told) {
    await(told::isDone);
    return told.join();
  }

  private CompletableFuture<String> read(RosLightSensor sensor) {
    CompletableFuture<String> told = new CompletableFuture<>();
    after(
        0,
        () ->
            sensor.read(
                new IlluminationSensor.Listener() {
                  @Override
                  public void measured(double lux) {
                    told.complete(lux + " lux");
                  }

                  @Override
                  public void failed(String reason) {
                    told.complete(reason);
                  }
                }));
    return told;
  }

  @Test
  void aReadingIsOneThatComesAfterItWasAskedFor() {
    RosLightSensor sensor = new RosLightSensor(bridge, "/lux", this::after);
    await(() -> server.subscribed("/lux").isPresent());
    assertThat(server.subscribed("/lux")).hasValue("sensor_msgs/msg/Illuminance");
    server.tell("/lux", "{\"illuminance\": 80.0, \"variance\": 0.0}");
    await(() -> sensor.fault().isEmpty());

    CompletableFuture<String> told = read(sensor);
    assertThat(told).isNotDone();
    await(
        () -> {
          server.tell("/lux", "{\"illuminance\": 310.5, \"variance\": 0.0}");
          return told.isDone();
        });
    assertThat(outcome(told)).isEqualTo("310.5 lux");
  }

  @Test
  void whatIsNoSuchMessageIsTold() {
    RosLightSensor sensor = new RosLightSensor(bridge, "/lux", this::after);
    await(() -> server.subscribed("/lux").isPresent());
    server.tell("/lux", "{\"illuminance\": null}");
    await(() -> sensor.fault().orElse("").contains("What comes on /lux"));

    assertThat(sensor.fault())
        .hasValue(
            "What comes on /lux is no sensor_msgs/msg/Illuminance: illuminance is no number.");
    assertThat(outcome(read(sensor))).isEqualTo(sensor.fault().orElseThrow());

    server.send("what?");
    server.send("{\"op\": \"dance\"}");
    server.tell("/lux", "{\"illuminance\": 5}");
    await(() -> sensor.fault().isEmpty());
  }

  @Test
  void aThermometerTellsTenths() {
    RosThermometer thermometer = new RosThermometer(bridge, "/temperature");
    await(() -> server.subscribed("/temperature").isPresent());
    server.tell("/temperature", "{\"temperature\": 21.4567, \"variance\": 0.0}");
    await(() -> thermometer.fault().isEmpty());
    assertThat(thermometer.celsius()).isEqualTo(21.5);
  }

  private RosCamera camera() {
    RosCamera camera =
        new RosCamera(
            bridge,
            new RosCamera.Topics(
                "/detections", "map", Map.of("cup", "green-cup"), Optional.of("/image")),
            new RosCamera.Light(72, 2000),
            this::after);
    await(() -> server.subscribed("/image").isPresent());
    return camera;
  }

  /** Tells the same frame until the look is over. */
  private String seen(RosCamera camera, String frame) {
    server.tell("/detections", frame);
    await(() -> camera.fault().isEmpty() || camera.fault().orElse("").contains("What comes"));
    CompletableFuture<String> told = new CompletableFuture<>();
    after(
        0,
        () ->
            camera.look(
                CUP,
                5,
                new Camera.Listener() {
                  @Override
                  public void looked(Camera.Look look) {
                    told.complete(
                        "%d %s".formatted(look.detections(), look.position().orElseThrow()));
                  }

                  @Override
                  public void failed(String reason) {
                    told.complete(reason);
                  }
                }));
    await(
        () -> {
          server.tell("/detections", frame);
          return told.isDone();
        });
    return outcome(told);
  }

  private static String frame(String frameId, String results) {
    return "{\"header\": {\"frame_id\": \"%s\"}, \"detections\": [%s]}".formatted(frameId, results);
  }

  private static String hypothesis(String name, double score, double x) {
    return """
    {"results": [{"hypothesis": {"class_id": "%s", "score": %s},
     "pose": {"pose": {"position": {"x": %s, "y": 2, "z": 0.8}}}}]}\
    """
        .formatted(name, score, x);
  }

  @Test
  void whatTheDetectorShowsInAFewFramesIsThere() {
    RosCamera camera = camera();
    String cups =
        hypothesis("cup", 0.9, 1.5)
            + ", "
            + hypothesis("cup", 0.6, 4)
            + ", "
            + hypothesis("ball", 1, 7);
    assertThat(seen(camera, frame("map", cups))).isEqualTo("5 " + new Position(1.5, 2, 0.8));
  }

  @Test
  void theOlderFormOfDetectionsIsReadToo() {
    String older =
        """
        {"results": [{"id": 7, "score": 0.9,
         "pose": {"pose": {"position": {"x": 1, "y": 2, "z": 3}}}}]}\
        """;
    RosCamera camera =
        new RosCamera(
            bridge,
            new RosCamera.Topics("/detections", "map", Map.of("7", "green-cup"), Optional.empty()),
            new RosCamera.Light(72, 2000),
            this::after);
    await(() -> server.subscribed("/detections").isPresent());
    assertThat(seen(camera, frame("/map", older))).isEqualTo("5 " + new Position(1, 2, 3));
  }

  @Test
  void thatAThingIsNotThereIsNeverSaid() {
    RosCamera camera = camera();
    assertThat(seen(camera, frame("map", hypothesis("ball", 0.9, 1))))
        .isEqualTo(
            "0 of 15 frames show green-cup in one place, which does not say whether it is there.");
  }

  @Test
  void positionsInAnotherFrameAreNotTaken() {
    RosCamera camera = camera();
    assertThat(seen(camera, frame("camera_link", hypothesis("cup", 0.9, 1))))
        .isEqualTo(
            "What comes on /detections is no vision_msgs/msg/Detection3DArray: header.frame_id is"
                + " \"camera_link\", and the home's frame is map; have its positions transformed.");
  }

  @Test
  void aPictureIsTakenFromItsImages() throws IOException {
    RosCamera camera = camera();
    BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
    image.setRGB(1, 0, 0x00FF10);
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    ImageIO.write(image, "png", png);
    String data = Base64.getEncoder().encodeToString(png.toByteArray());

    CompletableFuture<Photo> taken = new CompletableFuture<>();
    after(
        0,
        () ->
            camera.photograph(
                new Camera.PhotoListener() {
                  @Override
                  public void taken(Photo photo) {
                    taken.complete(photo);
                  }

                  @Override
                  public void failed(String reason) {
                    taken.completeExceptionally(new AssertionError(reason));
                  }
                }));
    await(
        () -> {
          server.tell("/image", "{\"format\": \"png\", \"data\": \"%s\"}".formatted(data));
          return taken.isDone();
        });
    assertThat(taken.join().width()).isEqualTo(2);
    assertThat(taken.join().at(1, 0)).isEqualTo(0x00FF10);
  }
}
