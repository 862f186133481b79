/* MQTT 5 over a socket, as much of it as a device needs. Where there is a client already, such as an ESP32's, that one
 * takes its place: it has to speak MQTT 5, since only that shows whether a call was sent with the retain flag.
 * Nothing is sent a second time: a device tells what is retained anew after each connect, and who misses a result asks
 * again by the same id. */
#ifndef MQTT_H
#define MQTT_H
#include <stdbool.h>
#include <stdint.h>

#include "json.h"

enum {
  MOST_IN = 2048,      /* bytes of a packet; the broker is told so, and sends no longer one */
  MOST_OUT = 1280,     /* of which a bell's description takes most */
  MOST_TOPIC = 192,
  MOST_UNANSWERED = 4, /* messages that the broker may send before the first is dealt with */
  KEEP_ALIVE_SECONDS = 15,
  PATIENCE_SECONDS = 5 /* with a broker that stops in the middle of a packet */
};

/* By quality of service 1, with the retain flag as it was published, and nothing of what was retained before. */
enum { HEAR_ALL = 0x29, HEAR_OTHERS = 0x2d };

typedef struct {
  Text topic, payload;
  bool is_retained;
} Message;

typedef enum { NOTHING, MESSAGE, GONE, TAKEN_OVER } Event;

int64_t now_ms(void);

/* With a will that is retained; false where no broker lets it in. */
bool mqtt_connect(const char *host, const char *port, const char *client, const char *will_topic, const char *will);
void mqtt_hear(const char *filter, unsigned char how);

/* A message is begun, said in parts, and sent; one that got too long is not. */
__attribute__((format(printf, 1, 2))) void mqtt_begin(const char *topic, ...);
__attribute__((format(printf, 1, 2))) void mqtt_say(const char *part, ...);
void mqtt_send(bool retained);

/* Waits until then at most. A message is there until this is called again, which acknowledges it. */
Event mqtt_wait(int64_t until_ms, Message *message);
#endif
