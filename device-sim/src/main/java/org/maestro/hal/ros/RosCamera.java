package org.maestro.hal.ros;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Target;
import org.maestro.hal.wheels.WheeledBase;

/**
 * A camera behind ROS with a detector. It says what the detector shows. That something is not there
 * it never says, as nothing is known of what the detector misses: such a look fails. Clock thread
 * only.
 */
public final class RosCamera implements Camera {

  /** Frames that show a thing in the same place before it is said; one may be mistaken. */
  private static final int AGREEING = 3;

  /** So many frames without that are enough. */
  private static final int MOST_FRAMES = 15;

  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(5);
  private static final Duration DETECTIONS_PAUSE = Duration.ofMillis(30);
  private static final Duration PICTURES_PAUSE = Duration.ofMillis(500);
  private static final double PICTURE_WITHIN_SECONDS = 5;
  private static final double LOOKS_EVERY_SECONDS = 0.1;
  private static final double NANOS = 1e9;

  private final RosTopic<List<RosDetections.Detection>> detections;
  private final Optional<RosTopic<byte[]>> pictures;
  private final Light light;
  private final WheeledBase.Pace pace;
  private final List<Looking> looks = new ArrayList<>();
  private Optional<RosTopic.Heard<List<RosDetections.Detection>>> before = Optional.empty();
  private double framesPerSecond;

  /**
   * The topics of a camera.
   *
   * @param detections tells vision_msgs/Detection3DArray, one for each frame, also when there is
   *     nothing to tell
   * @param frame in which their positions are: the home's
   * @param thingByClass what the detector's classes are in the home, where names differ
   * @param pictures tells sensor_msgs/CompressedImage
   */
  public record Topics(
      String detections,
      String frame,
      Map<String, String> thingByClass,
      Optional<String> pictures) {
    public Topics {
      thingByClass = Map.copyOf(thingByClass);
    }
  }

  /** The light from which and up to which the camera is said to work; lux. */
  public record Light(double minimum, double maximum) {}

  public RosCamera(RosBridge bridge, Topics topics, Light light, WheeledBase.Pace pace) {
    RosDetections reading = new RosDetections(topics.frame(), topics.thingByClass());
    this.light = light;
    this.pace = pace;
    this.detections =
        bridge.listen(
            topics.detections(),
            RosType.DETECTIONS,
            DETECTIONS_PAUSE,
            reading::read,
            frame -> pace.after(0, this::see));
    this.pictures =
        topics
            .pictures()
            .map(
                topic ->
                    bridge.listen(
                        topic, RosType.IMAGE, PICTURES_PAUSE, RosPicture::bytes, bytes -> {}));
  }

  /** Why it shows nothing of now, one sentence for people. */
  public Optional<String> fault() {
    return detections.fault(LONGEST_SILENCE);
  }

  @Override
  public void look(Target target, int frames, Listener listener) {
    Looking look = new Looking(target.name(), frames, listener);
    looks.add(look);
    watch(look);
  }

  /** Where no frames come, nothing else ends a look. */
  private void watch(Looking look) {
    Optional<String> fault = fault();
    if (fault.isPresent() && looks.remove(look)) {
      look.listener().failed(fault.get());
    } else if (looks.contains(look)) {
      pace.after(LOOKS_EVERY_SECONDS, () -> watch(look));
    }
  }

  /** One more frame is there; those that came at once are one. */
  private void see() {
    Optional<RosTopic.Heard<List<RosDetections.Detection>>> last =
        detections.last().filter(now -> before.filter(now::equals).isEmpty());
    last.ifPresent(
        now -> {
          before.ifPresent(
              then -> framesPerSecond = NANOS / Math.max(1, now.atNanos() - then.atNanos()));
          before = last;
          for (Looking look : List.copyOf(looks)) {
            look.add(now.value());
            if (look.isOver(AGREEING, MOST_FRAMES) && looks.remove(look)) {
              look.tell(AGREEING);
            }
          }
        });
  }

  @Override
  public void photograph(PhotoListener listener) {
    if (pictures.isEmpty()) {
      listener.failed("The camera tells no pictures.");
      return;
    }
    RosTopic<byte[]> topic = pictures.get();
    long taken = topic.last().map(RosTopic.Heard::number).orElse(0L);
    await(topic, taken, PICTURE_WITHIN_SECONDS, listener);
  }

  @Override
  public void photograph(int widest, PhotoListener listener) {
    photograph(
        new PhotoListener() {
          @Override
          public void taken(Photo photo) {
            listener.taken(photo.atMost(widest));
          }

          @Override
          public void failed(String reason) {
            listener.failed(reason);
          }
        });
  }

  private void await(RosTopic<byte[]> topic, long taken, double seconds, PhotoListener listener) {
    Optional<RosTopic.Heard<byte[]>> next = topic.last().filter(now -> now.number() > taken);
    if (next.isPresent()) {
      develop(next.get().value(), listener);
    } else if (seconds > 0) {
      pace.after(
          LOOKS_EVERY_SECONDS, () -> await(topic, taken, seconds - LOOKS_EVERY_SECONDS, listener));
    } else {
      listener.failed(
          topic.fault(LONGEST_SILENCE).orElse("The camera has told no picture in time."));
    }
  }

  /** Beside the clock, as it takes long. */
  private void develop(byte[] bytes, PhotoListener listener) {
    ForkJoinPool.commonPool()
        .execute(
            () -> {
              Optional<Photo> photo = RosPicture.photo(bytes);
              pace.after(
                  0,
                  () ->
                      photo.ifPresentOrElse(
                          listener::taken,
                          () -> listener.failed("The camera's pictures are no PNG or JPEG.")));
            });
  }

  @Override
  public double minimumLux() {
    return light.minimum();
  }

  @Override
  public double maximumLux() {
    return light.maximum();
  }

  /** Nobody knows, so that nothing is concluded from what is not shown. */
  @Override
  public double detectability(double lux) {
    return 0;
  }

  /** As the last two frames came; 0 before. */
  @Override
  public double frameRate() {
    return framesPerSecond;
  }

  /** It is not known what its lens has in view. */
  @Override
  public double shareInView(String area) {
    return 0;
  }
}
